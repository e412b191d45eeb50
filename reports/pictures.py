"""Pictures of all fields of a run, by pyvista if it works, otherwise by matplotlib."""

from collections.abc import Mapping, Sequence
from contextlib import nullcontext, suppress
from importlib.metadata import version
from pathlib import Path

from reports import picture_cache
from reports.bitmaps import flaw
from reports.drawing_process import DrawingProcess
from reports.picture_cache import Drawn
from reports.scene import Scene, compose
from verify.core.figures import Field, Picture

# seconds to start and for one picture: many times what a busy machine needs
START, EACH = 60.0, 3.0


def draw(
    requests: Sequence[tuple[Field, Picture]],
    cache: Path | None,
    *,
    hint: str = "",
    seconds: float | None = None,
    process: DrawingProcess | None = None,
) -> list[Drawn]:
    """Requested pictures, in order; pictures in the folder `cache` are not drawn again.

    pyvista draws in a `process`, by default a separate process for this call, which is ended after
    `seconds`. matplotlib draws the pictures that fail; `Drawn.why` states the reason and ends with
    `hint` (the packages to install). Raises ValueError for a field that cannot be drawn (see
    `reports.bodies.body`).
    """
    keys = [picture_cache.key(*request) for request in requests]
    found = {}
    missing = {}
    for name, request in zip(keys, requests, strict=True):
        if cache and (stored := picture_cache.load(cache, name)):
            found[name] = stored
        elif name not in missing:
            missing[name] = compose(*request)
    new = _drawn(missing, hint, seconds, process)
    if cache:
        for name, drawn in new.items():
            with suppress(OSError):  # a full disk costs the time to draw again, no picture
                picture_cache.store(cache, name, drawn)
    return [(found | new)[name] for name in keys]


def _drawn(
    scenes: Mapping[str, Scene], hint: str, seconds: float | None, process: DrawingProcess | None
) -> dict[str, Drawn]:
    """All scenes, drawn by pyvista or matplotlib."""
    if not scenes:
        return {}
    limit = START + EACH * len(scenes) if seconds is None else seconds
    with nullcontext(process) if process else DrawingProcess() as place:
        images, trouble = place.draw(list(scenes.values()), limit)
    drawn = {}
    for (name, scene), image in zip(scenes.items(), images, strict=True):
        why = flaw(image, scene.width, scene.height) if image else trouble
        if not why:
            drawn[name] = _result(scene, image, f"pyvista {version('pyvista')}", "")
            continue
        from reports import raster  # matplotlib takes half a second that pyvista does not need

        message = f"pyvista cannot draw on this machine ({why}); matplotlib was used"
        drawn[name] = _result(
            scene, raster.draw(scene), f"matplotlib {version('matplotlib')}",
            f"{message}; {hint}" if hint else message,
        )  # fmt: skip
    return drawn


def _result(scene: Scene, image: bytes, by: str, why: str) -> Drawn:
    return Drawn(
        image=image, width=scene.width, height=scene.height, rectangle=scene.rectangle,
        low=scene.scale.low, high=scene.scale.high, ramp=scene.scale.stops,
        exaggeration=scene.exaggeration, outline=scene.outline, by=by, why=why,
    )  # fmt: skip
