"""Data types of figures: fields, pictures, plots, sketches, tables. Plain data."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]


LIMITS_TITLE = "Limits of the part"  # table of a check


@dataclass(frozen=True, kw_only=True)
class Field:
    """A solved mesh for pictures and files: `points` (n, 2 or 3), `cells` (m, corners) and data."""

    name: str
    points: Array
    cells: NDArray[np.int64]
    point_data: Mapping[str, Array] = field(default_factory=dict)
    cell_data: Mapping[str, Array] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Picture:
    """How to draw one field: which data, in which unit, deformed how.

    `data` names point or cell data of the field called `field`, `component` a column of it;
    values are divided by `factor` to come in `unit`; no data draws in one colour. `mirror` lists
    the coordinates ("x", "y") that reflection negates: "x" completes a part of a symmetric body
    at the plane x = 0. `width` sweeps a line into a ribbon that can be turned [the points' unit].
    `share` is how large the largest displacement is drawn over the body's size, where the usual
    share would hide the shape. `window` (left, bottom, right, top) shows a part of the undeformed
    body, displacements less their mean there. Of `decades` the data are powers of ten, which the
    colour bar names in `unit`.
    """

    field: str
    data: str
    symbol: str
    unit: str
    factor: float
    caption: str
    component: int | None = None
    displacement: str = "displacement"
    mirror: tuple[str, ...] = ()
    width: float | None = None
    window: tuple[float, float, float, float] | None = None
    share: float | None = None
    decades: bool = False


@dataclass(frozen=True, kw_only=True)
class Profile:
    """A formula's curve and finite-element values on it, for a plot with the difference below.

    `x`, `y` draw the formula; at `x_fem` the formula gives `y_ref` and finite elements `y_fem`
    with standard uncertainty `u`. Differences are divided by `scale`, which `scale_name` names.
    Those of a formula that `neglects` something may exceed the uncertainty.
    """

    title: str
    x_label: str
    y_label: str
    x: Array
    y: Array
    x_fem: Array
    y_fem: Array
    y_ref: Array
    u: Array
    scale: float
    scale_name: str = ""
    note: str = ""
    neglects: bool = False


@dataclass(frozen=True, kw_only=True)
class Refinement:
    """Errors on finer and finer meshes, log-log: how fast each quantity goes to its limit.

    Each of `errors`, a name and relative errors (m,), is drawn over `cells` (m,), how many lie on
    the length that `x_label` names, beside a line of `order` through its last point.
    """

    title: str
    x_label: str
    y_label: str
    cells: Array
    errors: tuple[tuple[str, Array], ...]
    order: float
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Dots:
    """Values of one quantity side by side: name, value, half-width or None, and whose it is.

    The last is "formula", "fe" or "paper".
    """

    title: str
    label: str
    items: tuple[tuple[str, float, float | None, str], ...]
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Curve:
    """One of several curves: points x, y (m,), drawn as "line", "dashes" or "dots".

    Curves of one `colour` (0 to 5) belong together.
    """

    name: str
    x: Array
    y: Array
    style: str = "line"
    colour: int = 0


@dataclass(frozen=True, kw_only=True)
class Band:
    """The range between two curves, `lower` and `upper` over x (m,), behind those of its colour."""

    name: str
    x: Array
    lower: Array
    upper: Array
    colour: int = 0


@dataclass(frozen=True, kw_only=True)
class Curves:
    """Several curves on the same axes, named below, from `y_bottom` on (zero, or the lowest).

    Curves are clipped at `y_top`. `x_names` puts names where x has the values given.
    `bands` lie behind the curves. `y_log` spaces y by its logarithm, from the lowest on, `x_log`
    x; values that are not positive are left out.
    """

    title: str
    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    note: str = ""
    y_top: float | None = None
    y_bottom: float | None = None
    x_names: tuple[tuple[float, str], ...] = ()
    bands: tuple[Band, ...] = ()
    y_log: bool = False
    x_log: bool = False


@dataclass(frozen=True, kw_only=True)
class Map:
    """Where a formula holds: its signed relative error `error` (k, m) over two parameters.

    Columns and rows have names, the first row at the bottom; cells are shaded by the first of the
    `limits` that holds them. If the error is NaN there is nothing to compare, for the reason
    `without`. `checked` (k, m) are the cells that `checked_name` is true of.
    """

    title: str
    x_label: str
    y_label: str
    columns: tuple[str, ...]
    rows: tuple[str, ...]
    error: Array
    limits: tuple[float, ...] = (0.02, 0.05, 0.10)
    checked: NDArray[np.bool_] | None = None
    checked_name: str = "also by finite elements"
    without: str = ""
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Panel:
    """A state of something thin: `lines` (m, 2) each, `faint` ones behind, `dots` (m, 2) on it."""

    name: str
    lines: tuple[Array, ...]
    faint: tuple[Array, ...] = ()
    dots: Array | None = None


@dataclass(frozen=True, kw_only=True)
class Shapes:
    """States side by side, all to one scale, in `unit`; lines are `thickness` wide there."""

    title: str
    unit: str
    panels: tuple[Panel, ...]
    thickness: float = 0.0
    dots_name: str = ""
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Zone:
    """A zone from the top of the zone below to `top` (m,); `tone` "good", "fair" or "bad"."""

    name: str
    top: Array
    tone: str


@dataclass(frozen=True, kw_only=True)
class Zones:
    """Which state holds where in a plane: zones stacked over `x` (m,) from y = 0 up to `y_top`.

    A zone whose top is not above the zone below is not drawn. `curves` are drawn over
    them; `point` is a place and its name. Zones are named where they lie, so that colours, which
    `figures.css` makes distinct for the colour-blind and in print, need not be distinguished.
    """

    title: str
    x_label: str
    y_label: str
    x: Array
    zones: tuple[Zone, ...]
    y_top: float
    curves: tuple[Curve, ...] = ()
    point: tuple[float, float, str] | None = None
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Density:
    """A quantity `z` (k, m) over a plane, in colours: columns at `x` (m,), rows at `y` (k,), even.

    `range` is the colour scale, common to compared figures; None: the range of z.
    `point` is a place and its name.
    """

    title: str
    x_label: str
    y_label: str
    z_label: str
    x: Array
    y: Array
    z: Array
    range: tuple[float, float] | None = None
    point: tuple[float, float, str] | None = None
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Bars:
    """Contributions as bars from zero, one below the other: name, value, and text."""

    title: str
    label: str
    items: tuple[tuple[str, float, str], ...]
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Mode:
    """A mode of turning shafts: for each shaft places z (m,) and displacements x, y (m,) there.

    Displacements are complex, of any size: at the time t they are the real parts of x e^{iωt} and
    y e^{iωt}, ω > 0. A circle run through from x to y, y = -ix, is forward whirl of a shaft that
    turns so; y = ix is backward whirl; x and y in phase stay in a plane.
    """

    name: str
    lines: tuple[tuple[Array, ComplexArray, ComplexArray], ...]


@dataclass(frozen=True, kw_only=True)
class Whirl:
    """Modes of coaxial shafts in space and, on the page, in motion; all to one scale along z.

    `outlines` are z and radius (m,) of each shaft, a step as two points of one z; `names` call the
    shafts. `supports` are the places z of bearings to ground, `links` those between shafts.
    Lengths are in `unit`.
    """

    title: str
    unit: str
    modes: tuple[Mode, ...]
    outlines: tuple[tuple[Array, Array], ...]
    supports: tuple[float, ...] = ()
    links: tuple[float, ...] = ()
    names: tuple[str, ...] = ()
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Campbell:
    """Natural frequencies (n, branches) over the speed (n,), in the units of the labels.

    `whirl` of each branch is 1 (forward), -1 (backward) or 0 (neither); `names` stand at their
    ends. `excitations` are lines through the origin: name and frequency per speed. `critical` are
    speed, frequency and name of where they meet branches; `peers` speeds and frequencies (k,) of
    `peers_name`. The speeds of operation, `range`, are shaded.
    """

    title: str
    x_label: str
    y_label: str
    speeds: Array
    frequencies: Array
    whirl: tuple[int, ...]
    names: tuple[str, ...] = ()
    excitations: tuple[tuple[str, float], ...] = ()
    critical: tuple[tuple[float, float, str], ...] = ()
    range: tuple[float, float] | None = None
    peers: tuple[Array, Array] | None = None
    peers_name: str = ""
    y_top: float | None = None
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class ParallelAxis:
    """An upright axis from `low` to `high`, in `unit`, spaced by the logarithm where `log`."""

    name: str
    unit: str
    low: float
    high: float
    log: bool = False


@dataclass(frozen=True, kw_only=True)
class Parallel:
    """Sets of parameters as lines across upright axes: `members` (k, axes), some `highlighted`.

    The latter are row, name and colour (0 to 5); the others are thin.
    """

    title: str
    axes: tuple[ParallelAxis, ...]
    members: Array
    highlighted: tuple[tuple[int, str, int], ...] = ()
    members_name: str = ""
    note: str = ""


Figure = (
    Profile | Refinement | Dots | Curves | Map | Shapes | Zones | Density | Bars
    | Whirl | Campbell | Parallel
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Shape:
    """A line of a sketch: `points` (n, 2) in the unit of the case, drawn as `style`.

    Styles: "body" (closed outline, filled), "modelled" (closed: what finite elements take of
    it), "hole" (closed, cut out), "line" (centre line of something thin), "axis", "faint",
    "clamp" (hatched on the left of its direction), "load" (an arrow to its last point),
    "dimension" (arrows at both ends, `label` between them), "angle" (an arc with both
    arrows), "leader" (from the label to its last point) and "text" (`label` at its only point).
    """

    style: str
    points: Array
    label: str = ""


@dataclass(frozen=True, kw_only=True)
class Sketch:
    """What a case looks like, as data; `title` says it in words."""

    title: str
    shapes: tuple[Shape, ...]


@dataclass(frozen=True, kw_only=True)
class FormulaValue:
    """A value of the analytic side in its display unit; `judged` where a row pairs it with FE.

    `form` is "as printed" or "corrected" where a formula has several; `safe` the side on which an
    error does no harm, "too high" or "too low".
    """

    key: str = ""
    symbol: str
    what: str
    value: float
    unit: str
    judged: bool
    equation: str = ""
    source: str = ""
    form: str = ""
    safe: str = ""


@dataclass(frozen=True, kw_only=True)
class Table:
    """A table for printing; cells are strings or numbers."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str | float | None, ...], ...]
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Equation:
    """An equation as TeX and the same with numbers put in."""

    tex: str
    numbers: str = ""
    place: str = ""
    is_step: bool = False  # a number that other formulas take, not a result


@dataclass(frozen=True, kw_only=True)
class InputValue:
    """One input in its display unit."""

    name: str
    symbol: str
    what: str
    value: float | int | str
    unit: str
    source: str = ""
