"""Shell surfaces: rectangle, cylinder panel, strip along a plane path.

All lengths must be in one consistent unit.
"""

from meshes.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
