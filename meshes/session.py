"""Context that starts and ends gmsh; meshes are reproducible, and no data remain in gmsh."""

from collections.abc import Iterator
from contextlib import contextmanager

import gmsh

FRONTAL_DELAUNAY = 6


@contextmanager
def gmsh_session() -> Iterator[None]:
    """Gmsh session with one thread, a fixed algorithm, complete quadratic cells and no output."""
    gmsh.initialize(["gmsh", "-v", "0", "-nt", "1"], readConfigFiles=False, interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("Mesh.Algorithm", FRONTAL_DELAUNAY)
        gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 0)  # scikit-fem has no quad8
        yield
    finally:
        gmsh.finalize()
