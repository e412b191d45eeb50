"""Case ring-loads."""
