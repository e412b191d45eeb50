"""Case contact-slip."""
