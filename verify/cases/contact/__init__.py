"""Cases of the subject contact."""
