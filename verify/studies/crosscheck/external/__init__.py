"""Scripts for the separate environment of the second solvers; input and output are JSON files."""
