"""Linear shells on nine-node quadrilaterals in space."""
