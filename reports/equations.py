"""Equations as SVG: drawn once, kept for the next run, their glyphs shared over a page."""

import json
import re
from contextlib import suppress
from importlib.metadata import version
from pathlib import Path

from markupsafe import Markup, escape

from verify.core.files import write_whole

# a glyph with its outlines, or an empty one (a space), which closes itself
_SYMBOL = re.compile(r'<symbol id="([^"]+)" viewBox="([^"]+)"(?:\s*/>|>(.*?)</symbol>)', re.DOTALL)
_USE = re.compile(
    r'<use href="#([^"]+)" x="([^"]+)" y="([^"]+)" width="[^"]+" height="([^"]+)"[^>]*/>'
)
UNSEEN = 0.005  # pixels
_COLOUR = ' fill="currentColor"'


class Glyphs:
    """Equations of one page; `cache` is a folder that keeps what ziamath drew."""

    def __init__(self, cache: Path | None = None) -> None:
        self._names: dict[tuple[str, str], str] = {}
        self._kept = _Kept(cache)

    def maths(self, tex: str, size: int = 15) -> Markup:
        """TeX as inline SVG in the colour of the text; read aloud as its source."""
        drawn = self._kept.drawn(tex, size)
        glyphs = {name: (box, outline) for name, box, outline in _SYMBOL.findall(drawn)}
        drawn = _USE.sub(lambda use: self._placed(use, *glyphs[use[1]]), _SYMBOL.sub("", drawn))
        box = re.search(r'viewBox="([^"]+)"', drawn)
        assert box is not None
        _, top, _, height = map(float, box[1].split())
        start = (
            f'<svg class="maths" role="img" aria-label="{escape(tex)}" '
            f'style="vertical-align:{-(height + top):.1f}px" '
        )
        drawn = drawn.replace(_COLOUR, "").replace("<svg ", start, 1)
        return Markup(drawn)  # noqa: S704 - ziamath's own output

    def _placed(self, use: re.Match[str], box: str, outline: str) -> str:
        """A glyph in its place: of its size already, so that only the place need be told."""
        if not outline:
            return ""
        left, top, _, height = map(float, box.split())
        k = float(use[4]) / height
        # ziamath reuses one id for different glyphs: they are told apart by content
        name = self._names.setdefault((outline, f"{k:.4g}"), f"g{len(self._names)}")
        corner = (("x", float(use[2]) - k * left), ("y", float(use[3]) - k * top))
        place = "".join(f' {axis}="{v:.2f}"' for axis, v in corner if abs(v) > UNSEEN)
        return f'<use href="#{name}"{place}/>'

    def symbols(self) -> str:
        """The shared glyphs, for one hidden SVG; keeps what is new."""
        self._kept.store()
        paths = (
            f'<g id="{name}" transform="scale({k})">{_tight(outline)}</g>'
            for (outline, k), name in self._names.items()
        )
        return f"<defs>{''.join(paths)}</defs>"


def _tight(outline: str) -> str:
    """Outlines without the blanks that no reader needs."""

    def data(path: re.Match[str]) -> str:
        letters = re.sub(r" ?([A-Za-z]) ?", r"\1", path[1])
        return f' d="{letters.replace(" -", "-").strip()}"'

    return re.sub(r' d="([^"]*)"', data, outline)


class _Kept:
    """What ziamath drew, by its TeX: drawing takes tens of milliseconds each."""

    def __init__(self, folder: Path | None) -> None:
        self._path = folder / f"equations-{version('ziamath')}.json" if folder else None
        self._all: dict[str, str] = {}
        self._new = False
        with suppress(OSError, ValueError, AttributeError):  # absent or torn: drawn again
            if self._path:
                stored = json.loads(self._path.read_text("utf-8"))
                self._all = {k: v for k, v in stored.items() if isinstance(v, str)}

    def drawn(self, tex: str, size: int) -> str:
        name = f"{size} {tex}"
        if name not in self._all:
            import ziamath  # its font takes a fifth of a second to load

            self._all[name] = ziamath.Latex(tex, size=size, color="currentColor").svg()
            self._new = True
        return self._all[name]

    def store(self) -> None:
        """Replace the file; a full disk costs the time to draw again, no equation."""
        if not (self._path and self._new):
            return
        with suppress(OSError):
            kept = json.dumps(self._all, ensure_ascii=False).encode()
            write_whole(self._path, lambda file: file.write(kept))
