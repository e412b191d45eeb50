"""Pictures of all fields of a run: by pyvista where it works, else by matplotlib, drawn once."""

import signal
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from reports import picture_cache
from reports.bitmaps import flaw
from reports.picture_cache import Drawn
from reports.scene import Scene, compose
from verify.core.figures import Field, Picture

PYVISTA = "reports.render"
# seconds to start and for one picture: many times what a busy machine needs
START, EACH = 60.0, 3.0


def draw(
    requests: Sequence[tuple[Field, Picture]],
    cache: Path | None,
    *,
    hint: str = "",
    seconds: float | None = None,
) -> list[Drawn]:
    """Every picture wanted, in order; what `cache` (a folder) holds is not drawn again.

    pyvista draws in one process of its own, ended after `seconds`; what it fails to draw is drawn
    by matplotlib, and `Drawn.why` says so, with `hint` (what to install) at its end. Raises
    ValueError for a field that can't be drawn at all (see `reports.bodies.body`).
    """
    keys = [picture_cache.key(*request) for request in requests]
    found = {}
    missing = {}
    for name, request in zip(keys, requests, strict=True):
        if cache and (stored := picture_cache.load(cache, name)):
            found[name] = stored
        elif name not in missing:
            missing[name] = compose(*request)
    new = _drawn(missing, hint, seconds)
    if cache:
        for name, drawn in new.items():
            with suppress(OSError):  # a full disk costs the time to draw again, no picture
                picture_cache.store(cache, name, drawn)
    return [(found | new)[name] for name in keys]


def _drawn(scenes: Mapping[str, Scene], hint: str, seconds: float | None) -> dict[str, Drawn]:
    """All scenes drawn, by one means or the other."""
    if not scenes:
        return {}
    limit = START + EACH * len(scenes) if seconds is None else seconds
    images, trouble = _by_pyvista(list(scenes.values()), limit)
    drawn = {}
    for (name, scene), image in zip(scenes.items(), images, strict=True):
        why = flaw(image, scene.width, scene.height) if image else trouble
        if not why:
            drawn[name] = _result(scene, image, f"pyvista {version('pyvista')}", "")
            continue
        from reports import raster  # matplotlib takes half a second that pyvista does not need

        said = f"pyvista cannot draw here ({why}): drawn by matplotlib"
        drawn[name] = _result(
            scene, raster.draw(scene), f"matplotlib {version('matplotlib')}",
            f"{said}; {hint}" if hint else said,
        )  # fmt: skip
    return drawn


def _by_pyvista(scenes: Sequence[Scene], seconds: float) -> tuple[list[bytes], str]:
    """WebPs, empty where there is none, and what went wrong with the process."""
    with tempfile.TemporaryDirectory(prefix="pictures-") as name:
        folder = Path(name)
        arrays: dict[str, Any] = {}
        for i, scene in enumerate(scenes):
            arrays[f"size {i}"] = np.array([scene.width, scene.height])
            for part in ("vertices", "faces", "colours"):
                arrays[f"{part} {i}"] = getattr(scene, part)
        np.savez(folder / "scenes.npz", count=np.array(len(scenes)), **arrays)
        trouble = _ended([sys.executable, "-P", "-m", PYVISTA, name], seconds)
        paths = [folder / f"{i}.webp" for i in range(len(scenes))]
        return [p.read_bytes() if p.exists() else b"" for p in paths], trouble


def _ended(command: Sequence[str], seconds: float) -> str:
    """How the process failed, in a few words; "no picture" where it says it did not."""
    try:
        done = subprocess.run(  # noqa: S603 - this interpreter
            command, timeout=seconds, stdin=subprocess.DEVNULL, capture_output=True, check=False
        )
    except subprocess.TimeoutExpired:
        return f"not done after {seconds:g} s"
    except OSError as error:
        return str(error)
    if done.returncode < 0:
        return f"signal {-done.returncode}, {signal.strsignal(-done.returncode)}"
    if done.returncode:
        last = done.stderr.decode(errors="replace").strip().rpartition("\n")[2]
        return f"exit status {done.returncode}{': ' if last else ''}{last[:200]}"
    return "no picture"


def _result(scene: Scene, image: bytes, by: str, why: str) -> Drawn:
    return Drawn(
        image=image, width=scene.width, height=scene.height, rectangle=scene.rectangle,
        low=scene.scale.low, high=scene.scale.high, ramp=scene.scale.stops,
        exaggeration=scene.exaggeration, outline=scene.outline, by=by, why=why,
    )  # fmt: skip
