"""Meshes of bodies in contact, with fine cells near the contact at the origin.

All lengths must be in one consistent unit. Messages state metres.
"""

from meshes.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
