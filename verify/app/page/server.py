"""The server of the page, with its port, its token, and the folder that it may use."""

import asyncio
import secrets
import socket
import webbrowser
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Timer
from typing import Any

import uvicorn
from fastapi import FastAPI, HTTPException
from fastapi.responses import FileResponse
from nicegui import ui

from verify.app.page.described import describe
from verify.app.page.folder import Folder
from verify.app.page.guard import Guard
from verify.app.page.jobs import Jobs, Worker
from verify.app.page.place import FIRST, Place
from verify.app.page.screen import Screen
from verify.core.inputs import InputError

HOST = "127.0.0.1"
STARTED = 60.0  # s in which the first page must be there, also on a slow machine
LAST_PORT = 65535
BROWSER_AFTER = 0.5  # s
RECONNECTED = 30.0  # s in which a browser that was busy with a drawing finds its page unchanged


def run_app(file: Path | None, *, folder: Path, port: int, browser: bool) -> int:
    """Serve the page until Ctrl-C.

    Raises InputError if the folder, the file or the port is invalid.
    """
    chosen = Folder(folder)
    first = ""
    if file is not None:
        first = str(file.resolve().relative_to(chosen.root)) if _within(file, chosen) else str(file)
        if not chosen.path(first, ".toml").is_file():
            raise InputError(f"{file}: there is no such file in {chosen.root}")
    taken = bound(port)
    port = int(taken.getsockname()[1])
    token = secrets.token_urlsafe(24)
    address = f"http://{HOST}:{port}/?token={token}"
    with taken, TemporaryDirectory(prefix="freewheel-app-") as reports:
        place = Place(chosen, Path(reports), Worker(), Worker(), Jobs(), first)
        print(f"freewheel app: {address}\nfolder {chosen.root}; Ctrl-C ends", flush=True)
        if browser:
            timer = Timer(BROWSER_AFTER, webbrowser.open, (address,))
            timer.daemon = True
            timer.start()
        with suppress(KeyboardInterrupt):
            _serve(Guard(application(place), token=token, port=port), taken)
    return 0


def bound(port: int) -> socket.socket:
    """Socket that accepts connections from this machine only.

    Raises InputError if the port is invalid or in use.
    """
    if not 0 <= port <= LAST_PORT:
        raise InputError(f"--port must be 0 to {LAST_PORT}, got {port}")
    found = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        found.bind((HOST, port))
        found.listen()
    except OSError as error:
        found.close()
        raise InputError(
            f"--port {port}: {error.strerror}; give another port, or 0 for a free one"
        ) from error
    return found


def application(place: Place) -> FastAPI:
    """Application with the page and the files of its reports, without access control."""

    @asynccontextmanager
    async def running(_app: FastAPI) -> Any:
        warm = asyncio.create_task(place.formulas.ask(describe, FIRST))
        yield
        warm.cancel()
        place.formulas.end()
        place.details.end()
        place.jobs.end()

    served = FastAPI(lifespan=running, docs_url=None, redoc_url=None, openapi_url=None)

    @served.get("/reports/{name:path}")
    def report_file(name: str) -> FileResponse:
        try:
            path = Folder(place.reports).path(name)
        except InputError as error:
            raise HTTPException(404) from error
        if not path.is_file():
            raise HTTPException(404)
        return FileResponse(path)

    @ui.page("/", response_timeout=STARTED)
    async def page(s: str = "") -> None:
        await Screen(place).build(s)

    ui.run_with(served, title="freewheel app", dark=None, show_welcome_message=False,
                reconnect_timeout=RECONNECTED)  # fmt: skip
    return served


def _serve(app: Guard, taken: socket.socket) -> None:
    config = uvicorn.Config(
        app, log_level="warning", server_header=False, ws_max_size=1_000_000,
        timeout_graceful_shutdown=2, limit_concurrency=200,
    )  # fmt: skip
    uvicorn.Server(config).run(sockets=[taken])


def _within(file: Path, folder: Folder) -> bool:
    return file.resolve().is_relative_to(folder.root)
