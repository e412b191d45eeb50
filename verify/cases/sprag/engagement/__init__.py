"""Case sprag-engagement."""
