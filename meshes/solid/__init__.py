"""Solids in space: second-order hexahedra of strips swept over their width, and of blocks.

Lengths in any consistent unit; messages state metres.
"""

from meshes.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
