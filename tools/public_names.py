"""Public names of packages: `python -m tools.public_names` writes docs/api/names.md."""

import inspect
import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "api" / "names.md"
HEAD = """# Public names

Each package exports the names below from its modules: `from analytic.ring import lame`,
`from fem.plane import Elastic, solve_plane`. A module is imported when one of its names is first
used. If a function has the same name as its module, it is exported under a longer name, for
example `solve_modes` for the function in `fem.rotor.modes`. If the functions of a module have
general names, the module itself is exported: `hertz_line.pressure`.
`python -m tools.public_names` writes this page.
"""


def packages() -> list[str]:
    """Dotted names of the packages that have public names."""
    stubs = (p for top in ("analytic", "fem", "meshes") for p in (ROOT / top).rglob("*.pyi"))
    return sorted(".".join(stub.parent.relative_to(ROOT).parts) for stub in stubs)


def names(package: str) -> dict[str, object]:
    """Public names of a package with their objects."""
    module = import_module(package)
    return {name: getattr(module, name) for name in module.__all__}


def page() -> str:
    """Text of the page of all public names."""
    return "\n".join([HEAD, *(line for package in packages() for line in _section(package))])


def _section(package: str) -> Iterator[str]:
    yield f"## {package}\n"
    yield "| name | | module |"
    yield "|---|---|---|"
    for name, thing in names(package).items():
        text = " ".join((inspect.getdoc(thing) or "").split("\n\n")[0].split()).replace("|", r"\|")
        text = re.sub(r":math:`([^`]*)`", r"`\1`", text)
        text = text.replace("*", r"\*").replace("<", r"\<").replace("$", r"\$")
        home = thing.__name__ if isinstance(thing, ModuleType) else thing.__module__
        yield f"| `{name}` | {text} | `{home}` |"
    yield ""


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
