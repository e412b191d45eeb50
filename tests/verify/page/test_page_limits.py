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


def recorded() -> tuple[Answering, list[Any], list[float]]:
    """What answers a page, with the inputs that it requests and their limits of time."""
    asked: list[Any] = []
    limits: list[float] = []

    async def ask(_function: Any, raw: Any, *_: Any, seconds: float = 1e9) -> Shown:
        asked.append(raw)
        limits.append(seconds)
        return Shown(verdict="holds", design=str(raw), assumed={"E": ("E = 206 GPa", "steel")})

    worker = SimpleNamespace(ask=ask)
    screen = SimpleNamespace(
        place=SimpleNamespace(formulas=worker, details=worker), asked=lambda state: (state.raw,),
        session=SimpleNamespace(state=None),
    )  # fmt: skip
    return Answering(screen), asked, limits


def test_an_answer_and_its_slow_notes_have_a_limit_of_time() -> None:
    answering, _, limits = recorded()
    state = State("ring-lame", "my")
    answering.found = asyncio.run(answering._asked(state))
    asyncio.run(answering._details(state))
    assert limits == [LONGEST, LONGEST]


def test_variant_b_is_computed_again_only_where_it_has_changed() -> None:
    answering, asked, _ = recorded()
    one, two = {"x": "1"}, {"x": "2"}
    states = [State("a", "my", {"x": k}, other) for k, other in (
        ("1", None), ("1", one), ("3", one), ("4", two), ("4", two), ("4", None), ("4", one),
    )]  # fmt: skip
    found = [asyncio.run(answering._of_stored(state)) for state in states]
    designs = [None if one is None else one.design for one in found]
    assert designs == [None, str(one), str(one), str(two), str(two), None, str(one)]
    assert asked == [one, two, one]
    asyncio.run(answering._of_stored(State("b", "my", {"x": "4"}, one)))
    assert asked[3:] == [one]  # of another case


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
