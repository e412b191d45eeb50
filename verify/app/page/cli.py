"""How `freewheel app` is called."""

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
    """Open a local page: inputs of a part, its answer while typing, finite elements, sweeps.

    The page is served on 127.0.0.1 only, and only to the browser that opens the printed address.

    Parameters
    ----------
    file
        Parameter file (TOML) in the folder, which the page then shows.
    folder
        The page reads and writes files of this folder alone, by default the current one.
    port
        Port of the page, 0 for any that is free.
    browser
        Open the page in the browser.
    """
    from verify.app.page.server import run_app

    return run_app(file, folder=folder, port=port, browser=browser)
