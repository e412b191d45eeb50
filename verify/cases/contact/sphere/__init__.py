"""Case contact-sphere."""
