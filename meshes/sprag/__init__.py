"""Cyclic sectors of sprag clutches."""
