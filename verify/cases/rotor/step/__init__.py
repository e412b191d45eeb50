"""Case rotor-step."""
