"""What is compared with second solvers, by subject."""
