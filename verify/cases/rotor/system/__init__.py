"""Case rotor-system."""
