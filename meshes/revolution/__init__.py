"""Half-sections of bodies of revolution: x is the radius, y the axial coordinate.

All lengths must be in one consistent unit. Messages state metres.
"""

from meshes.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
