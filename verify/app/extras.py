"""Optional dependencies (extras) of the package, and conflicts of its module names."""

import re
from importlib.metadata import PackageNotFoundError, packages_distributions, requires

PACKAGE = "freewheel-verification"
TOP_LEVEL = ("analytic", "fem", "meshes", "reports", "verify")
LIBRARIES = {  # by module
    "skfem": "scikit-fem", "sklearn": "scikit-learn", "PIL": "pillow",
    "fastapi": "nicegui", "uvicorn": "nicegui",
}  # fmt: skip


def extra_of(module: str) -> str:
    """Extra of the package that installs the library of a module; "" if there is none.

    >>> extra_of("skfem")
    'fem'
    """
    library = LIBRARIES.get(module, module)
    try:
        requirements = requires(PACKAGE) or ()
    except PackageNotFoundError:  # a checkout that is not installed
        return ""
    for one in requirements:
        extra = re.search(r"""extra == ["'](\w+)["']""", one)
        if extra and re.match(r"[\w-]+", one)[0].lower() == library:  # type: ignore[index]
            return extra[1]
    return ""


def missing_library(error: ImportError) -> str:
    """Message for a missing library, with the command that installs it."""
    module = str(error.name or "").partition(".")[0]
    extra = extra_of(module)
    if not extra:
        return f"{error}: see freewheel doctor"
    return (
        f"{LIBRARIES.get(module, module)} is not installed; this command needs it: "
        f"pip install '{PACKAGE}[{extra}]'"
    )


def shared_names() -> list[str]:
    """Top-level module names of this package that another installed package has as well."""
    owners = packages_distributions()
    return [name for name in TOP_LEVEL if set(owners.get(name, ())) - {PACKAGE}]
