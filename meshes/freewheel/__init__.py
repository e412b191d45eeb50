"""Cyclic sectors of roller freewheels."""
