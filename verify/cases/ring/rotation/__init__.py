"""Case ring-rotation."""
