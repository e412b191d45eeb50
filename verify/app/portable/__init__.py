"""The command `portable`."""
