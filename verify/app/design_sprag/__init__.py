"""The command `design` for the crown of a sprag."""
