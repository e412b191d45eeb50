"""Half-sections of stepped shafts: x is the radius, y the axis."""
