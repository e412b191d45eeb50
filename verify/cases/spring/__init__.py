"""Cases of the subject spring."""
