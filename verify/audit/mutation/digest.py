"""Hash of the code for which a measurement is valid."""

import hashlib

from verify.audit.mutation.tracing import ROOT

ALL = ("analytic", "fem", "meshes", "verify", "tests")


def digest(*folders: str) -> str:
    """Hash of the named files, and of all Python files in the named folders.

    By default, all sources on which the score depends are included.
    """
    found = hashlib.sha256()
    for folder in folders or ALL:
        place = ROOT / folder
        for path in sorted(place.rglob("*.py")) if place.is_dir() else [place]:
            found.update(f"{path.relative_to(ROOT)}\0".encode())
            found.update(path.read_bytes())
    return found.hexdigest()[:32]
