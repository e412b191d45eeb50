"""Of what the difference of formula and finite elements is made: one cause changed, rerun."""
