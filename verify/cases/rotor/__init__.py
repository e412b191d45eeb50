"""Cases of the subject rotor."""
