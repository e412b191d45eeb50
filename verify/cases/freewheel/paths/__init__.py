"""Case freewheel-paths."""
