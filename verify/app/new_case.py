"""The command `new-case`: writes a commented file that declares a case and runs unchanged."""

from pathlib import Path

from verify.app.arguments import ProblemKind
from verify.core.inputs import InputError


def template(kind: ProblemKind) -> Path:
    """Path of the template for a kind of problem."""
    return Path(__file__).parent / "templates" / f"{kind.replace('-', '_')}.py"


def run_new_case(file: Path, kind: ProblemKind) -> int:
    """Write the template of a case to a new file.

    Raises InputError if the file exists or its name is not that of a Python module.
    """
    if file.suffix != ".py" or not file.stem.isidentifier():
        raise InputError(f"{file}: the name must consist of letters, digits and _, and end in .py")
    try:
        with file.open("x", encoding="utf-8") as new:
            text = template(kind).read_text("utf-8")
            new.write(text.replace("FILE", file.name, 1))
    except FileExistsError:
        raise InputError(f"{file}: exists already and is not overwritten") from None
    except OSError as error:
        raise InputError(f"{file}: cannot be written: {error.strerror}") from error
    print(f"written: {file}; edit it, then: freewheel verify {file}")
    return 0
