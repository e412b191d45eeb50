"""Section of a screen that lists, loads and saves parameter files and displays a link."""

from dataclasses import replace
from typing import Any

from markupsafe import Markup
from nicegui import ui

from verify.app.page.toml_text import parameter_file, read_state
from verify.app.page.widgets import Choice, Typed, button, html, message, tool
from verify.core.inputs import InputError


class FileView:
    """Section "File" of one screen, with the list of files and the fields for saving."""

    def __init__(self, screen: Any) -> None:
        self.screen = screen
        with tool("File", "tool-file"):
            self.listed = ui.element("div").classes("row")
            self._list()
            with ui.element("div").classes("row"):
                state = screen.session.state
                self.title = Typed("Name of the part", "part-name", state.name)
                self.name = Typed("File", "save-name", f"{state.name.replace(' ', '-')}.toml")
                self.replace = Choice("Where it exists", {"": "refuse", "yes": "replace"},
                                      "save-replace")  # fmt: skip
                button("Save", self._save, name="save")
                button("Download", self._download, name="download")
                button("Copy the link of this session", self._copy, name="copy")
            self.status = html().props('id="file-status" role="status"')

    def _list(self, chosen: str = "") -> None:
        """Update the list of the files in the folder. `chosen` is selected if it is one of them."""
        names = self.screen.place.folder.names_of(".toml", below=True)
        self.listed.clear()
        with self.listed:
            every = dict.fromkeys([*names, *filter(None, [chosen])])
            files = {name: name for name in every} or {"": "no parameter file"}
            self.file = Choice("In the folder", files, "load-name", chosen)
            button("Load", self._load, name="load")

    async def _load(self) -> None:
        try:
            state = read_state(self.screen.place.folder.path(self.file.value, ".toml"))
        except InputError as error:
            self.status.set_content(message(str(error)))
            return
        await self.screen.show(state)

    def _named(self) -> str:
        session = self.screen.session
        session.state = replace(session.state, name=self.title.value.strip() or "my part")
        return parameter_file(session.state)

    def _save(self) -> None:
        try:
            text, name = self._named(), self.name.value
            self.screen.place.folder.write(name, text, ".toml", replace=bool(self.replace.value))
        except InputError as error:
            self.status.set_content(message(str(error)))
            return
        self.status.set_content(str(Markup("saved as {} in the folder").format(name)))
        self._list(name)

    def _download(self) -> None:
        ui.download.content(self._named(), self.name.value, "application/toml")

    def _copy(self) -> None:
        ui.run_javascript("navigator.clipboard?.writeText(location.href)")
        self.status.set_content("the address of this page, which holds the session, was copied")
