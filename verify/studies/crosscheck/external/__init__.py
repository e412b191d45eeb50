"""Scripts for the separate environment of second solvers: JSON in, JSON out."""
