"""Sectors of rings whose bore is a polygon."""
