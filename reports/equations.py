"""Equations as SVG: drawn once, kept for the next run, their glyphs shared over a page."""

import hashlib
import json
import re
from contextlib import suppress
from importlib.metadata import version
from pathlib import Path

from markupsafe import Markup, escape

from verify.files import write_whole

# a glyph with its outline, or an empty one (a space), which closes itself
_SYMBOL = re.compile(r'<symbol id="([^"]+)"([^>]*/>|[^>]*>.*?</symbol>)', re.DOTALL)


class Glyphs:
    """Equations of one page; `cache` is a folder that keeps what ziamath drew."""

    def __init__(self, cache: Path | None = None) -> None:
        self._known: dict[str, str] = {}
        self._kept = _Kept(cache)

    def maths(self, tex: str, size: int = 15) -> Markup:
        """TeX as inline SVG in the colour of the text; read aloud as its source."""
        drawn = self._kept.drawn(tex, size)
        for name, glyph in _SYMBOL.findall(drawn):
            # ziamath reuses one id for different glyphs: name them by content
            unique = "g" + hashlib.sha256(glyph.encode()).hexdigest()[:10]
            self._known[unique] = f'<symbol id="{unique}"{glyph}'
            drawn = drawn.replace(f'"#{name}"', f'"#{unique}"')
        drawn = _SYMBOL.sub("", drawn)
        box = re.search(r'viewBox="([^"]+)"', drawn)
        assert box is not None
        _, top, _, height = map(float, box[1].split())
        start = (
            f'<svg class="maths" role="img" aria-label="{escape(tex)}" '
            f'style="vertical-align:{-(height + top):.1f}px" '
        )
        return Markup(drawn.replace("<svg ", start, 1))  # noqa: S704 - ziamath's own output

    def symbols(self) -> str:
        """The shared glyphs, for one hidden SVG; keeps what is new."""
        self._kept.store()
        return "".join(self._known.values())


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
