"""Case freewheel-cup."""
