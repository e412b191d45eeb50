"""Case sprag-crown."""
