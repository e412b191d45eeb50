"""Shell surfaces: rectangle, cylinder panel, strip along a plane path.

Lengths in any consistent unit.
"""

from meshes.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
