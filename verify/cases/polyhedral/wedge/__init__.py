"""Case polyhedral-wedge."""
