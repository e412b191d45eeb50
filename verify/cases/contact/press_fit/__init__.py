"""Case contact-press-fit."""
