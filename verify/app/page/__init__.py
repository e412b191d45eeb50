"""Command `app`: a local page for the design of a part."""
