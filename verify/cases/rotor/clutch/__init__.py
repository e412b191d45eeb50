"""Case rotor-clutch."""
