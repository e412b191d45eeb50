"""Design of a sprag clutch's crown: the one with the lowest pressures in its engagements."""
