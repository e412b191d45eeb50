"""Requests are served only with the token, from this machine, and from the page itself."""

import asyncio
from typing import Any

import pytest

from verify.app.page.guard import Guard

TOKEN, PORT = "secret-token", 8080
HOST, ORIGIN = f"127.0.0.1:{PORT}", f"http://127.0.0.1:{PORT}"
COOKIE = f"freewheel-{PORT}={TOKEN}"


async def _served(_scope: Any, _receive: Any, send: Any) -> None:
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": b"the page"})


def answers(kind: str = "http", path: str = "/", query: str = "", **headers: str) -> list[Any]:
    """What the guard sends for one request."""
    sent: list[Any] = []

    async def send(message: Any) -> None:
        sent.append(message)

    async def receive() -> Any:
        return {"type": "websocket.connect"}

    given = [(k.replace("_", "-").encode(), v.encode()) for k, v in headers.items()]
    scope = {"type": kind, "path": path, "query_string": query.encode(), "headers": given}
    asyncio.run(Guard(_served, token=TOKEN, port=PORT)(scope, receive, send))
    return sent


def test_the_token_gives_a_cookie_and_leaves_the_address() -> None:
    first = answers(host=HOST, query=f"token={TOKEN}&s=abc")[0]
    headers = dict(first["headers"])
    assert first["status"] == 303
    assert headers[b"location"] == b"/?s=abc"
    assert headers[b"set-cookie"].startswith(COOKIE.encode())
    assert b"HttpOnly; SameSite=Strict" in headers[b"set-cookie"]


def test_the_cookie_opens_the_page_and_its_websocket() -> None:
    assert answers(host=HOST, cookie=COOKIE)[1]["body"] == b"the page"
    assert answers("websocket", host=HOST, origin=ORIGIN, cookie=COOKIE)[0]["status"] == 200


@pytest.mark.parametrize("headers", [
    {"host": "evil.example"}, {"host": f"evil.example:{PORT}"}, {"host": "127.0.0.1:99"}, {},
    {"host": HOST, "origin": "http://evil.example"}, {"host": HOST, "origin": "null"},
    {"host": HOST, "origin": "http://127.0.0.1:81"}, {"host": HOST, "origin": f"https://{HOST}"},
    {"host": HOST, "content_length": "9" * 9}, {"host": HOST, "content_length": "x"},
])  # fmt: skip
def test_other_hosts_origins_and_large_requests_are_refused(headers: dict[str, str]) -> None:
    assert answers(cookie=COOKIE, **headers)[0]["status"] == 403


@pytest.mark.parametrize("headers", [
    {"host": HOST, "origin": ORIGIN}, {"host": HOST, "origin": ORIGIN, "cookie": "x=y"},
    {"host": HOST, "cookie": COOKIE}, {"host": "evil.example", "origin": ORIGIN, "cookie": COOKIE},
    {"host": HOST, "origin": "http://evil.example", "cookie": COOKIE},
])  # fmt: skip
def test_a_websocket_needs_cookie_host_and_origin(headers: dict[str, str]) -> None:
    assert answers("websocket", "/_nicegui_ws/socket.io/", **headers)[0]["code"] == 1008


@pytest.mark.parametrize(("path", "query"), [
    ("/", ""), ("/", "token=wrong"), ("/", "token="), ("/_nicegui/x.js", f"token={TOKEN}"),
    ("/reports/1/part.toml", ""),
])  # fmt: skip
def test_without_the_token_nothing_is_served(path: str, query: str) -> None:
    assert answers(path=path, query=query, host=HOST)[0]["status"] == 403


@pytest.mark.parametrize("cookie", [
    f"freewheel-{PORT}=wrong", f"freewheel-{PORT}=", f"freewheel-{PORT}", f"freewheel-81={TOKEN}",
    f"other={TOKEN}", f"freewheel-{PORT}={TOKEN}x", "\x00",
])  # fmt: skip
def test_a_cookie_without_the_token_opens_nothing(cookie: str) -> None:
    assert answers(path="/x", host=HOST, cookie=cookie)[0]["status"] == 403
    assert answers("websocket", host=HOST, origin=ORIGIN, cookie=cookie)[0]["code"] == 1008


def test_the_page_that_asks_for_the_token_keeps_the_session_and_escapes_it() -> None:
    body = answers(host=HOST, query="s=%22%3E%3Cscript%3E")[1]["body"].decode()
    assert 'value="&quot;&gt;&lt;script&gt;"' in body
    assert "<script" not in body


def test_a_request_of_another_site_is_refused() -> None:
    sent = answers(path="/x", host=HOST, cookie=COOKIE, sec_fetch_site="cross-site")
    assert sent[0]["status"] == 403
