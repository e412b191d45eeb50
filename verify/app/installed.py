"""Installed versions of packages, compared with the locked ones."""

import re
from importlib.metadata import PackageNotFoundError, version

PIN = re.compile(r"^([A-Za-z0-9._-]+)==([^\s;]+)(?:\s*;\s*(.*?))?\s*\\?$", re.MULTILINE)


def installed(name: str) -> str:
    """The version of a package; "" if it is not installed."""
    try:
        return version(name)
    except PackageNotFoundError:
        return ""


def mismatches(lock: str) -> list[str]:
    """Packages of a lock that are not installed in its version, each with both versions."""
    return [
        f"{name} {installed(name) or 'absent'}, lock {locked}"
        for name, locked, marker in PIN.findall(lock)
        if installed(name) != locked and (not marker or _applies(marker))
    ]


def _applies(marker: str) -> bool:
    """Whether a pin for certain systems applies to this one; False if that is unknown."""
    try:
        from packaging.markers import Marker
    except ImportError:
        return False
    return Marker(marker).evaluate()
