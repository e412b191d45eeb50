"""Process in which pyvista draws; it starts with the first scenes and runs until closed."""

import select
import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, Self

import numpy as np

from reports.scene import Scene

PYVISTA = "reports.render"
NO_PICTURE = "no picture"


class DrawingProcess:
    """Context manager of the process, which is replaced on failure if it has drawn before."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._has_drawn, self._broken = False, ""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self._end()

    def draw(self, scenes: Sequence[Scene], seconds: float) -> tuple[list[bytes], str]:
        """WebP images of the scenes (empty for a missing image), and the reason of a failure."""
        if self._broken:
            return [b""] * len(scenes), self._broken
        with tempfile.TemporaryDirectory(prefix="pictures-") as name:
            folder = Path(name)
            arrays: dict[str, Any] = {}
            for i, scene in enumerate(scenes):
                arrays[f"size {i}"] = np.array([scene.width, scene.height])
                for part in ("vertices", "faces", "colours"):
                    arrays[f"{part} {i}"] = getattr(scene, part)
            np.savez(folder / "scenes.npz", count=np.array(len(scenes)), **arrays)
            trouble = self._failure(name, seconds)
            paths = [folder / f"{i}.webp" for i in range(len(scenes))]
            images = [p.read_bytes() if p.exists() else b"" for p in paths]
        self._has_drawn |= not trouble
        if trouble:
            self._end()
            self._broken = "" if self._has_drawn else trouble
        return images, trouble or NO_PICTURE

    def _failure(self, folder: str, seconds: float) -> str:
        """Reason of a failure of the process in a few words; "" if it reports success."""
        try:
            process = self._process or self._start()
        except OSError as error:
            return str(error)
        assert process.stdin
        assert process.stdout
        with suppress(BrokenPipeError):  # the output is complete if the process has ended
            process.stdin.write(f"{folder}\n".encode())
        if not select.select([process.stdout], [], [], seconds)[0]:
            return f"not finished after {seconds:g} s"
        if process.stdout.readline():
            return ""
        code = process.wait()
        if code < 0:
            return f"signal {-code}, {signal.strsignal(-code)}"
        self._errors.seek(0)
        last = self._errors.read().decode(errors="replace").strip().rpartition("\n")[2]
        return f"exit status {code}{': ' if last else ''}{last[:200]}"

    def _start(self) -> subprocess.Popen[bytes]:
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115 - closed with the process
        self._process = subprocess.Popen(  # noqa: S603 - this interpreter
            [sys.executable, "-P", "-m", PYVISTA], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=self._errors, bufsize=0,
        )  # fmt: skip
        return self._process

    def _end(self) -> None:
        if self._process:
            with self._process as process, self._errors:
                process.kill()
            self._process = None
