"""Shell surfaces: rectangle, cylinder panel, strip along a plane path."""
