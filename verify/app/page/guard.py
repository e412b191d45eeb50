"""Access control: only the browser that opened the page with the token is accepted."""

import html
import secrets
from collections.abc import Awaitable, Callable, Mapping, MutableMapping
from http.cookies import CookieError, SimpleCookie
from typing import Any
from urllib.parse import parse_qsl, urlencode

Message = MutableMapping[str, Any]
Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

HOSTS = ("127.0.0.1", "localhost")
LARGEST_BODY = 1_000_000  # bytes of a request
POLICY_VIOLATION = 1008  # code with which a websocket is closed
HEADERS = (
    (b"x-content-type-options", b"nosniff"), (b"referrer-policy", b"no-referrer"),
    (b"x-frame-options", b"SAMEORIGIN"), (b"cache-control", b"no-store"),
)  # fmt: skip
ASK = """<!doctype html><html lang="en"><meta charset="utf-8"><title>freewheel app</title>
<meta name="viewport" content="width=device-width"><style>:root {{ color-scheme: light dark }}
body {{ font: 1rem/1.5 sans-serif; margin: 2rem auto; max-width: 38rem; padding: 0 1rem }}</style>
<h1>The page needs its token</h1><p>freewheel app printed an address with a token when it started.
Open this address, or enter the token here. The address of this page still has the inputs that were
typed.</p><form><label>Token <input name="token" autofocus></label>{hidden}
<button>Open</button></form></html>"""


class Guard:
    """An ASGI application that accepts requests of the page and refuses all others."""

    def __init__(self, app: App, *, token: str, port: int) -> None:
        self.app, self.token = app, token
        self.cookie = f"freewheel-{port}"  # browsers send a cookie to every port
        self.hosts = {f"{host}:{port}" for host in HOSTS}
        self.origins = {f"http://{host}" for host in self.hosts}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Check host and origin of a request, then the token."""
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        headers = {k.decode("latin-1"): v.decode("latin-1") for k, v in scope["headers"]}
        if reason := self._foreign(scope, headers):
            await _refuse(scope, receive, send, reason)
        elif self._is_known(headers):
            await self.app(scope, receive, _with_headers(send))
        elif scope["type"] == "http" and scope["path"] == "/":
            await self._admit(scope, send)
        else:
            await _refuse(scope, receive, send, "the page needs its token")

    def _foreign(self, scope: Scope, headers: Mapping[str, str]) -> str:
        """Reason why a request does not come from the page; "" if it does."""
        if headers.get("host") not in self.hosts:
            return "unknown host"
        origin = headers.get("origin")
        if origin not in self.origins and (origin or scope["type"] == "websocket"):
            return "unknown origin"
        if headers.get("sec-fetch-site") == "cross-site" and scope["path"] != "/":
            return "request of another site"
        length = headers.get("content-length", "0")
        if not length.isdecimal() or int(length) > LARGEST_BODY:
            return f"a request has at most {LARGEST_BODY:,} bytes"
        return ""

    def _is_known(self, headers: Mapping[str, str]) -> bool:
        try:
            found = SimpleCookie(headers.get("cookie", "")).get(self.cookie)
        except CookieError:
            return False
        return found is not None and self._is_token(found.value)

    def _is_token(self, text: str) -> bool:
        return secrets.compare_digest(text.encode(), self.token.encode())

    async def _admit(self, scope: Scope, send: Send) -> None:
        """Set the cookie if the address has the correct token.

        Otherwise, return a page with a field for the token.
        """
        query = dict(parse_qsl(scope["query_string"].decode("latin-1")))
        given = query.pop("token", "")
        if not self._is_token(given):
            hidden = "".join(
                f'<input type="hidden" name="{html.escape(k)}" value="{html.escape(v)}">'
                for k, v in query.items()
            )
            await _answer(send, 403, ASK.format(hidden=hidden), b"text/html; charset=utf-8")
            return
        cookie = f"{self.cookie}={self.token}; HttpOnly; SameSite=Strict; Path=/"
        place = "/" + (f"?{urlencode(query)}" if query else "")
        await _answer(send, 303, "", b"text/plain", (
            (b"location", place.encode()), (b"set-cookie", cookie.encode()),
        ))  # fmt: skip


def _with_headers(send: Send) -> Send:
    async def sent(message: Message) -> None:
        if message["type"] == "http.response.start":
            given = {name for name, _ in message.get("headers", ())}
            more = [one for one in HEADERS if one[0] not in given]
            message = {**message, "headers": [*message.get("headers", ()), *more]}
        await send(message)

    return sent


async def _refuse(scope: Scope, receive: Receive, send: Send, reason: str) -> None:
    if scope["type"] == "websocket":
        await receive()
        await send({"type": "websocket.close", "code": POLICY_VIOLATION, "reason": reason})
        return
    await _answer(send, 403, f"freewheel app: refused: {reason}\n", b"text/plain; charset=utf-8")


async def _answer(
    send: Send, status: int, text: str, kind: bytes, more: tuple[tuple[bytes, bytes], ...] = ()
) -> None:
    headers = [(b"content-type", kind), *HEADERS, *more]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": text.encode()})
