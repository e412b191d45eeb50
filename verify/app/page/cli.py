"""Arguments of the command `freewheel app`."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from verify.app.arguments import Number


def app(
    file: Path | None = None,
    /,
    *,
    folder: Path = Path(),
    port: Number = 8080,
    browser: Annotated[bool, Parameter(negative="--no-browser")] = True,
) -> int:
    """Open a local page in the browser: inputs of a part, answer, finite elements, sweeps.

    The page is served on 127.0.0.1 only, and only to the browser that opens the printed address.

    Parameters
    ----------
    file
        Parameter file (TOML) in the folder; its inputs are displayed first.
    folder
        Folder whose files the page can read and write; by default the current folder.
    port
        Port of the page; 0 for any free port.
    browser
        Open the page in the browser.
    """
    from verify.app.page.server import run_app

    return run_app(file, folder=folder, port=port, browser=browser)
