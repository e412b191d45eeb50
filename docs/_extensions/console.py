"""The directive `console`: runs commands of `freewheel` during the build and prints the output.

    ```{console}
    :lines: 4
    freewheel init sprag-clutch > sprag.toml
    freewheel check sprag.toml
    ```

All commands of a page run in one folder, which is empty at the beginning. `lines` limits the
number of lines of each output.
"""

import contextlib
import io
import shlex
import tempfile
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

from verify.app.cli import run

LOGGER = logging.getLogger(__name__)
WRONG_INPUT = 2
_folders: dict[str, tempfile.TemporaryDirectory[str]] = {}


def setup(app: Any) -> dict[str, bool]:
    app.add_directive("console", Console)
    return {"parallel_read_safe": True}


class Console(SphinxDirective):
    """Directive with one command per line; the page shows the commands and their output."""

    has_content = True
    option_spec: ClassVar = {"lines": directives.nonnegative_int}

    def run(self) -> list[nodes.Node]:
        page = self.env.docname
        folder = Path(_folders.setdefault(page, tempfile.TemporaryDirectory()).name)
        text = "\n".join(self._answer(command, folder) for command in self.content)
        return [nodes.literal_block(text, text, language="console")]

    def _answer(self, command: str, folder: Path) -> str:
        words, _, target = command.partition(" > ")
        output = io.StringIO()
        with contextlib.chdir(folder), contextlib.redirect_stdout(output):
            status = run(shlex.split(words)[1:])
        if status == WRONG_INPUT:
            LOGGER.warning("the command fails: %s", command, location=self.get_location())
        if target:
            (folder / target).write_text(output.getvalue(), "utf-8")
            return f"$ {command}"
        lines = output.getvalue().rstrip().splitlines()[: self.options.get("lines")]
        return "\n".join([f"$ {command}", *lines])
