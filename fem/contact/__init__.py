"""Contact of elastic and rigid bodies in the plane, with and without friction."""
