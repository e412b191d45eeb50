"""An answer has a limit of time, and no file outside of the folder is opened or run."""

import asyncio
import urllib.error
import urllib.request
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from tests.verify.page.conftest import Server, missing

if reason := missing():
    pytest.skip(reason, allow_module_level=True)

from verify.app.page.answering import Answering
from verify.app.page.answers import Shown
from verify.app.page.link import to_link
from verify.app.page.session import State

LONGEST = 60.0  # s of an answer, docs/app.md
WRITES = 'open(__file__ + ".ran", "w").close()\n'


def limits(state: State) -> list[float]:
    """The limits of time with which an answer and its slow notes are asked."""
    given: list[float] = []

    async def ask(*_: Any, seconds: float = 1e9, **__: Any) -> Shown:
        given.append(seconds)
        return Shown(verdict="holds", assumed={"E": ("E = 206 GPa", "steel")})

    worker = SimpleNamespace(ask=ask)
    screen = SimpleNamespace(
        place=SimpleNamespace(formulas=worker, details=worker), asked=lambda _: (),
        session=SimpleNamespace(state=None),
    )  # fmt: skip
    answering = Answering(screen)
    answering.found = asyncio.run(answering._asked(state))
    asyncio.run(answering._details(state))
    return given


def test_an_answer_and_its_slow_notes_have_a_limit_of_time() -> None:
    assert limits(State("ring-lame", "my")) == [LONGEST, LONGEST]


def fetched(server: Server, path: str, *, key: bool = True) -> tuple[int, str]:
    """Status and text of a request with the cookie of the page."""
    token = server.address.partition("token=")[2]
    cookie = {"Cookie": f"freewheel-{server.port}={token}"} if key else {}
    asked = urllib.request.Request(f"http://127.0.0.1:{server.port}{path}", headers=cookie)
    try:
        with urllib.request.urlopen(asked, timeout=60) as answer:
            return answer.status, answer.read().decode()
    except urllib.error.HTTPError as error:
        return error.code, error.read().decode()


def test_a_link_to_a_case_outside_of_the_folder_is_refused_and_not_run(
    server: Server, tmp_path: Path
) -> None:
    outside = server.folder.parent / "outside.py"
    outside.write_text(WRITES, "utf-8")
    for name in ("../outside.py", str(outside)):
        status, text = fetched(server, f"/?s={to_link(State(name, 'my', {'x': '1'}))}")
        assert status == 200
        assert "only files in the folder" in text
    assert not outside.with_name("outside.py.ran").exists()


@pytest.mark.parametrize("path", [
    "/reports/../.log", "/reports/..%2f..%2f..%2fetc/passwd", "/reports/%2e%2e/%2e%2e/etc/passwd",
    "/reports//etc/passwd", "/reports/none",
])  # fmt: skip
def test_no_file_beside_the_reports_is_served(server: Server, path: str) -> None:
    assert fetched(server, path)[0] == 404


def test_the_server_asks_for_the_token(server: Server) -> None:
    assert fetched(server, "/")[0] == 200
    assert fetched(server, "/", key=False)[0] == 403
    assert fetched(server, "/reports/none", key=False)[0] == 403
