"""Case sprag-clutch."""
