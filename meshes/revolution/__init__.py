"""Half-sections of bodies of revolution: x is the radius, y the axis.

Lengths in any consistent unit; messages state metres.
"""

from meshes.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
