"""Half-sections of bodies of revolution: x is the radius, y the axis."""
