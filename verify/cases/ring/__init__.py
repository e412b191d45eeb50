"""Cases of the subject ring."""
