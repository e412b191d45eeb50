"""Case sprag-optimum."""
