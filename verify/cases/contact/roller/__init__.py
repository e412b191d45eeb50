"""Case contact-roller."""
