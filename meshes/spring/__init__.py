"""Accordion springs: centre line and strip.

All lengths must be in one consistent unit.
"""

from meshes.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
