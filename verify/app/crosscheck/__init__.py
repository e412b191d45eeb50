"""The command `crosscheck`."""
