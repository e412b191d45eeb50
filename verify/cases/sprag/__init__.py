"""Cases of the subject sprag."""
