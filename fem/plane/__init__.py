"""Plane elasticity: one or several bodies on a mesh of triangles or quadrilaterals."""
