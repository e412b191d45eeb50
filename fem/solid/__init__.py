"""Linear elasticity in space on meshes of hexahedra.

All units must be consistent.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
