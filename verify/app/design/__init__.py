"""The command `design` for accordion springs."""
