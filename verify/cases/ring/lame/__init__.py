"""Case ring-lame."""
