"""Command app: a local page on which a part is dimensioned."""
