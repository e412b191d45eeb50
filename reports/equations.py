"""Equations as SVG: drawn once, stored for the next run, their glyphs shared over a page."""

import re
from collections.abc import Iterable
from contextlib import suppress
from importlib.metadata import version
from pathlib import Path

from markupsafe import Markup, escape

from verify.core.store import Store

# a glyph with its outlines, or an empty one (a space), which closes itself
_SYMBOL = re.compile(r'<symbol id="([^"]+)" viewBox="([^"]+)"(?:\s*/>|>(.*?)</symbol>)', re.DOTALL)
_USE = re.compile(
    r'<use href="#([^"]+)" x="([^"]+)" y="([^"]+)" width="[^"]+" height="([^"]+)"[^>]*/>'
)
KIND = "equation"  # of entries of the store
SIZE = 15  # pixels
UNSEEN = 0.005  # pixels
_COLOUR = ' fill="currentColor"'


class Glyphs:
    """Equations of one page; `cache` is the folder of the store that has what ziamath drew."""

    def __init__(self, cache: Path | None = None) -> None:
        self._names: dict[tuple[str, str], str] = {}
        self._stored = _Stored(cache)

    def prepare(self, equations: Iterable[str]) -> None:
        """Have equations drawn that will be asked for."""
        for tex in filter(None, equations):
            self._stored.drawn(tex, SIZE)

    def store(self) -> None:
        """Have what was drawn stored for the next run."""
        self._stored.store()

    def maths(self, tex: str, size: int = SIZE) -> Markup:
        """TeX as inline SVG in the colour of the text; read aloud as its source."""
        drawn = self._stored.drawn(tex, size)
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
        self.store()
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


class _Stored:
    """What ziamath drew, by its TeX: drawing takes tens of milliseconds each."""

    def __init__(self, folder: Path | None) -> None:
        self._store = Store(folder) if folder else None
        self._subject = f"ziamath {version('ziamath')}"
        self._all: dict[str, str] = {}
        self._new: dict[str, bytes] = {}
        with suppress(OSError, ValueError):  # what cannot be read is drawn again
            if self._store:
                stored = self._store.all(KIND, self._subject)
                self._all = {name: content.decode() for name, content in stored.items()}

    def drawn(self, tex: str, size: int) -> str:
        name = f"{self._subject} {size} {tex}"
        if name not in self._all:
            import ziamath  # its font takes a fifth of a second to load

            self._all[name] = ziamath.Latex(tex, size=size, color="currentColor").svg()
            self._new[name] = self._all[name].encode()
        return self._all[name]

    def store(self) -> None:
        """Add what is new; a full disk costs the time to draw again, no equation."""
        if self._store and self._new:
            with suppress(OSError):
                self._store.store(KIND, self._subject, self._new)
                self._new = {}
