"""Command design_sprag."""
