"""Scripts that second solvers run in a separate environment: JSON in, JSON out."""
