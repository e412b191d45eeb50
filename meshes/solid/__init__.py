"""Solids in space: second-order hexahedra of strips swept over their width, and of blocks."""
