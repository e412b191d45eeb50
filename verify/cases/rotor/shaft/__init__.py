"""Case rotor-shaft."""
