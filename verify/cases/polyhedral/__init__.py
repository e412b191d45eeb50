"""Cases of the subject polyhedral."""
