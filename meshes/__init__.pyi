from meshes.join import join as join_meshes
from meshes.line import LineMesh, line_mesh
from meshes.plane import plane_mesh
from meshes.session import gmsh_session

__all__ = ["LineMesh", "gmsh_session", "join_meshes", "line_mesh", "plane_mesh"]
