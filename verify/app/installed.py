"""Installed versions of packages, compared with the versions of the lock file."""

import re
from importlib.metadata import PackageNotFoundError, version

PIN = re.compile(r"^([A-Za-z0-9._-]+)==([^\s;]+)(?:\s*;\s*(.*?))?\s*\\?$", re.MULTILINE)


def installed(name: str) -> str:
    """Version of an installed package; "" if it is not installed."""
    try:
        return version(name)
    except PackageNotFoundError:
        return ""


def mismatches(lock: str) -> list[str]:
    """Packages whose installed version differs from that in the lock file, with both versions."""
    return [
        f"{name} {installed(name) or 'absent'}, lock file {locked}"
        for name, locked, marker in PIN.findall(lock)
        if installed(name) != locked and (not marker or _applies(marker))
    ]


def _applies(marker: str) -> bool:
    """Whether a `marker` of the lock file applies to this system; False if this is unknown."""
    try:
        from packaging.markers import Marker
    except ImportError:
        return False
    return Marker(marker).evaluate()
