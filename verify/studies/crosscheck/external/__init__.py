"""Scripts that second solvers run in an environment of their own: JSON in, JSON out."""
