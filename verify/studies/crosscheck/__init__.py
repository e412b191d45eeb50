"""Second solvers beside the project's own: its meshes and loads, posed to programs of others."""
