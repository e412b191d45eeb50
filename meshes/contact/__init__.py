"""Bodies that touch: cells fine around the contact at the origin, coarse far from it."""
