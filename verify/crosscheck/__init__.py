"""Second solvers beside the project's own: the same meshes and loads, posed to programs of others."""
