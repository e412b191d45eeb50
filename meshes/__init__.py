"""Geometries as meshes with named boundaries and bodies, made by gmsh in memory."""
