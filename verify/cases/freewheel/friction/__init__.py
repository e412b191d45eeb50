"""Case freewheel-friction."""
