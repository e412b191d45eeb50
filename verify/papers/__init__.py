"""What the five papers print, as data."""
