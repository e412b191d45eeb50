"""Linear elasticity in space on meshes of hexahedra."""
