"""Case ring-loads-map."""
