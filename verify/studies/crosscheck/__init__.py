"""Comparison with second solvers: other programs solve problems on the project's meshes."""
