"""The code that a measurement counts for, as a hash."""

import hashlib

from verify.audit.mutation.tracing import ROOT

ALL = ("analytic", "fem", "meshes", "verify", "tests")


def digest(*folders: str) -> str:
    """Hash of files and of all sources in folders, by default of all on which the score depends."""
    found = hashlib.sha256()
    for folder in folders or ALL:
        place = ROOT / folder
        for path in sorted(place.rglob("*.py")) if place.is_dir() else [place]:
            found.update(f"{path.relative_to(ROOT)}\0".encode())
            found.update(path.read_bytes())
    return found.hexdigest()[:32]
