"""Case sprag-wedge."""
