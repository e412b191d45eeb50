"""The command `new-case`: a file that declares a case, commented, which runs as it stands."""

from pathlib import Path

from verify.core.inputs import InputError


def run_new_case(file: Path) -> int:
    """Write the file; InputError where it exists or cannot be a module."""
    if file.suffix != ".py" or not file.stem.isidentifier():
        raise InputError(f"{file}: name a Python file: letters, digits and _, ending in .py")
    try:
        with file.open("x", encoding="utf-8") as new:
            text = Path(__file__).with_name("case_template.py").read_text("utf-8")
            new.write(text.replace("FILE", file.name, 1))
    except FileExistsError:
        raise InputError(f"{file}: exists already") from None
    except OSError as error:
        raise InputError(f"{file}: cannot be written: {error.strerror}") from error
    print(f"written: {file}; edit it, then: freewheel verify {file}")
    return 0
