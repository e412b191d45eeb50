"""Cases outside the suite: cases in a Python file or in an installed package.

An environment variable lists the loaded files, so that worker processes find them. A package
declares its classes as entry points of the group `freewheel.cases`.
"""

import importlib
import os
import sys
import traceback
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path

from pydantic import PydanticUserError

from verify.core import source_code
from verify.core.case import Case
from verify.core.inputs import InputError
from verify.form.adapter import adapted
from verify.form.case import Case as Form

GROUP = "freewheel.cases"
FILES = "FREEWHEEL_CASE_FILES"  # paths, separated like the entries of PATH


def is_file_name(name: str) -> bool:
    """Whether `name` of a case is the name of a Python file."""
    return name.endswith(".py")


def load(name: str) -> Case:
    """The last case that the file `name` declares; raises InputError if it declares none."""
    path = Path(name).expanduser().resolve()
    if not path.is_file():
        raise InputError(f"{name}: there is no such file")
    case = _loaded(path)
    known = os.environ.get(FILES, "").split(os.pathsep)
    if str(path) not in known:
        os.environ[FILES] = os.pathsep.join(filter(None, [*known, str(path)]))
    return case


def loaded() -> Iterator[Case]:
    """Cases of the files that this process or its parent process has loaded."""
    for path in filter(None, os.environ.get(FILES, "").split(os.pathsep)):
        yield _loaded(Path(path))


def installed() -> tuple[str, ...]:
    """Names of the cases that installed packages declare; no package is imported."""
    return tuple(sorted(point.name for point in entry_points(group=GROUP)))


@cache
def of_package(name: str) -> Case:
    """The case `name` of an installed package; raises InputError if it cannot be loaded."""
    (point,) = entry_points(group=GROUP, name=name)
    try:
        form = _form(point)
    except InputError:
        raise
    except (Exception, SystemExit) as error:
        raise InputError(f"{point.value}: {type(error).__name__}: {error}") from error
    return _stated(form)


def _stated(form: type[Form]) -> Case:
    """The case of the class `form`; raises InputError if the class breaks a rule for cases."""
    case = adapted(form, time_limit=form.time_limit)
    len(case.checks)
    return case


def _form(point: EntryPoint) -> type[Form]:
    form = point.load()
    if not (isinstance(form, type) and issubclass(form, Form) and form.title):
        raise InputError(f"{point.value}: must be a subclass of Case with a title")
    if form.id != point.name:
        raise InputError(f"{point.value}: its id {form.id} must equal the name of its entry point, "
                         f"{point.name}")  # fmt: skip
    package = importlib.import_module(form.__module__.partition(".")[0])
    source_code.include(Path(package.__file__ or "").parent)
    return form


@cache
def _loaded(path: Path) -> Case:
    name = path.stem
    if not name.isidentifier():
        raise InputError(f"{path}: rename the file: only letters, digits and _ are allowed")
    if str(path.parent) not in sys.path:
        sys.path.append(str(path.parent))  # for imports of files in its folder and for pickle
    source_code.include(path.parent)
    try:
        module = importlib.import_module(name)
        if Path(module.__file__ or "") != path:
            raise InputError(f"{path}: another module is called {name}; rename the file")
        found = [
            c for c in vars(module).values()
            if isinstance(c, type) and issubclass(c, Form) and c.__module__ == name and c.title
        ]  # fmt: skip
        if not found:
            raise InputError(f"{path}: declares no subclass of Case with a title")
        return replace(_stated(found[-1]), file=path)
    except InputError:
        raise
    except (Exception, SystemExit) as error:
        raise InputError(_message(error, path)) from error


def _message(error: BaseException, path: Path) -> str:
    """Message of one line: place and cause of the error in the user's file."""
    if isinstance(error, SyntaxError):
        return f"{path.name}:{error.lineno}: {error.msg}"
    text = " ".join(str(error).split())
    if text.startswith(f"{path.name}:"):  # an error of the form names its place
        return text
    if isinstance(error, PydanticUserError) and "non-annotated" in text:
        name = text.partition("`")[2].partition(" =")[0]
        rule = "annotate it, an input as float = given(...), a constant as ClassVar"
        return f"{path.name}: {name}: {rule}"
    frames = [f for f in traceback.extract_tb(error.__traceback__) if f.filename == str(path)]
    place = f"{path.name}:{frames[-1].lineno}" if frames else path.name
    where = f"{place}: {frames[-1].name}" if frames and frames[-1].name != "<module>" else place
    return f"{where}: {type(error).__name__}: {text}"
