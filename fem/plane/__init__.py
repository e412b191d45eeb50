"""Plane elasticity: one or several bodies on a mesh of triangles or quadrilaterals.

All units must be consistent.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
