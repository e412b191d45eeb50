"""Case rotor-sprag."""
