"""Solids in space: second-order hexahedra of strips swept over their width, and of blocks.

All lengths must be in one consistent unit. Messages state metres.
"""

from meshes.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
