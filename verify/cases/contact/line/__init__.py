"""Case contact-line."""
