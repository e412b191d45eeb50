"""Sweeps: formulas and finite elements over ranges of the inputs."""
