"""Drawing of all kinds of figures."""

import weakref

from markupsafe import Markup

from reports import plots
from reports.bars import bars
from reports.campbell import campbell
from reports.curves import curves
from reports.density import density
from reports.drawable import drawable, nothing
from reports.error_map import error_map
from reports.parallel import parallel
from reports.refinement import refinement
from reports.shapes import shapes
from reports.whirl import whirl
from reports.zones import zones
from verify.core.figures import (
    Bars,
    Campbell,
    Curves,
    Density,
    Dots,
    Figure,
    Map,
    Parallel,
    Profile,
    Refinement,
    Shapes,
    Whirl,
    Zones,
)

_plots: dict[int, Markup] = {}  # of the figures that are in use, by their identity


def plot(figure: Figure) -> Markup:
    """SVG of a figure, or a note if it has no points; made once for page and PDF."""
    key = id(figure)
    if key not in _plots:
        _plots[key] = _plot(figure)
        weakref.finalize(figure, _plots.pop, key).atexit = False
    return _plots[key]


def _plot(figure: Figure) -> Markup:
    if not drawable(figure):
        return nothing(figure.title)
    match figure:
        case Profile():
            return plots.profile(figure)
        case Refinement():
            return refinement(figure)
        case Dots():
            return plots.dots(figure)
        case Curves():
            return curves(figure)
        case Map():
            return error_map(figure)
        case Shapes():
            return shapes(figure)
        case Zones():
            return zones(figure)
        case Density():
            return density(figure)
        case Bars():
            return bars(figure)
        case Whirl():
            return whirl(figure)
        case Campbell():
            return campbell(figure)
        case Parallel():
            return parallel(figure)
