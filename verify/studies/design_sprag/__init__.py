"""Design of the crown of a sprag: the crown with the lowest pressures in engagements."""
