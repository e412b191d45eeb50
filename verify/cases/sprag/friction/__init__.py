"""Case sprag-friction."""
