"""The command line, its output and its figures."""
