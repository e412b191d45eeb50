"""The code that a measurement counts for, as a hash."""

import hashlib

from verify.mutation.tracing import ROOT

ALL = ("analytic", "fem", "meshes", "verify", "tests")


def digest(*folders: str) -> str:
    """Hash of all sources in the folders, by default of everything that the score depends on."""
    found = hashlib.sha256()
    for folder in folders or ALL:
        for path in sorted((ROOT / folder).rglob("*.py")):
            found.update(f"{path.relative_to(ROOT)}\0".encode())
            found.update(path.read_bytes())
    return found.hexdigest()[:32]
