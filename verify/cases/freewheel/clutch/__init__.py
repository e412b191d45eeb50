"""Case freewheel-clutch."""
