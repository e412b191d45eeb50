"""Case freewheel-torque."""
