"""Second solvers: the meshes and loads of the project, solved by other programs."""
