"""Data types of figures: fields, pictures, plots, sketches, tables (without functions)."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]


LIMITS_TITLE = "Limits of the part"  # table of a check


@dataclass(frozen=True, kw_only=True)
class Field:
    """Mesh with results, for pictures and files: `points` (n, 2 or 3) and `cells` (m, corners)."""

    name: str
    points: Array
    cells: NDArray[np.int64]
    point_data: Mapping[str, Array] = field(default_factory=dict)
    cell_data: Mapping[str, Array] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Picture:
    """Description of how one field is drawn: data, unit, deformation.

    `data` is the name of point or cell data of `field`, `component` a column of these data. Values
    are divided by `factor` to obtain `unit`. Without data, the body has one colour. `mirror` lists
    the coordinates ("x", "y") to be reflected: "x" completes a part of a symmetric body at the
    plane x = 0. With a `width` [unit of the points], a line is drawn as a ribbon that can be
    rotated.
    `share` is the largest displacement as drawn, divided by the size of the body; None selects the
    default. `window` (left, bottom, right, top) selects a part of the undeformed body;
    displacements are then relative to their mean in this part. Lengths along y are drawn `stretch`
    times as large as lengths along x. With `decades`, the data are logarithms to base ten, and the
    colour bar has powers of ten in `unit`.
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
    stretch: float = 1.0
    decades: bool = False


@dataclass(frozen=True, kw_only=True)
class Profile:
    """Plot of a formula and finite-element values along a line, with their difference below.

    `x`, `y` draw the formula. At `x_fem`, the formula gives `y_ref`, and finite elements give
    `y_fem` with standard uncertainty `u`. Differences are divided by `scale`, which has the name
    `scale_name`. If the formula `neglects` an effect, differences may exceed the uncertainty.
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
    """Plot of errors on increasingly fine meshes with logarithmic axes.

    Each entry of `errors` contains a name and relative errors (m,), which are drawn over `cells`
    (m,), the numbers of cells along the length that `x_label` names. A line of slope `order` is
    drawn through the last point of each entry.
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
    """Plot of values of one quantity: name, value, half-width of its error bar (or None), source.

    The source is "formula", "fe" or "paper".
    """

    title: str
    label: str
    items: tuple[tuple[str, float, float | None, str], ...]
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Curve:
    """A curve with points x, y (m,), drawn as "line", "dashes" or "dots".

    Curves with the same `colour` (0 to 5) belong together.
    """

    name: str
    x: Array
    y: Array
    style: str = "line"
    colour: int = 0


@dataclass(frozen=True, kw_only=True)
class Band:
    """The area between two curves, `lower` and `upper` over x (m,), with a `colour`."""

    name: str
    x: Array
    lower: Array
    upper: Array
    colour: int = 0


@dataclass(frozen=True, kw_only=True)
class Curves:
    """Plot of curves on common axes, with a legend below the plot.

    The y axis starts at `y_bottom`, by default at zero or the lowest value. Curves are clipped at
    `y_top`. `x_names` are names at given values of x. `bands` are drawn behind the curves. `y_log`
    and `x_log` select logarithmic axes that start at the lowest value; values that are not positive
    are omitted.
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
    """Map of the signed relative error `error` (k, m) of a formula over two parameters.

    Columns and rows have names; the first row is at the bottom. The shade of a cell is that of the
    smallest of the `limits` that the error does not exceed. If the error is NaN, there is no
    comparison; `without` states the reason. `checked` (k, m) marks the cells for which
    `checked_name` is true.
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
    """Drawing of one state of a body: `lines` (m, 2), `faint` lines behind them, `dots` (m, 2)."""

    name: str
    lines: tuple[Array, ...]
    faint: tuple[Array, ...] = ()
    dots: Array | None = None


@dataclass(frozen=True, kw_only=True)
class Shapes:
    """Drawing of several states next to each other on one scale, in `unit`.

    Lines are drawn with the real `thickness`.
    """

    title: str
    unit: str
    panels: tuple[Panel, ...]
    thickness: float = 0.0
    dots_name: str = ""
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Zone:
    """A zone of a plot: from the top of the next lower zone up to `top` (m,).

    `tone` is "good", "fair" or "bad".
    """

    name: str
    top: Array
    tone: str


@dataclass(frozen=True, kw_only=True)
class Zones:
    """Plot of zones above each other over `x` (m,), from y = 0 to `y_top`.

    A zone whose top is not above the zone below it is not drawn. `curves` are drawn over the zones.
    `point` is a position and its name. Zones have their names inside, so that their colours need
    not be distinguished. In `figures.css`, the colours are distinct for colour-blind readers and in
    print.
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
    """Plot of a quantity `z` (k, m) over a plane, in colours.

    Columns are at `x` (m,), rows at `y` (k,), in equal steps. `range` is the range of the colour
    scale, which is the same in compared figures; None selects the range of z. `point` is a position
    and its name.
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
    """Plot of contributions as horizontal bars from zero; an item is (name, value, text)."""

    title: str
    label: str
    items: tuple[tuple[str, float, str], ...]
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Mode:
    """A mode of rotating shafts: for each shaft, positions z (m,) and displacements x, y (m,).

    Displacements are complex, with any scale: at the time t, they are the real parts of x e^{iωt}
    and y e^{iωt}, ω > 0. If y = -ix, the motion is a circle from x to y: forward whirl of a shaft
    that rotates in this sense. If y = ix, it is backward whirl. If x and y are in phase, the motion
    is in a plane.
    """

    name: str
    lines: tuple[tuple[Array, ComplexArray, ComplexArray], ...]


@dataclass(frozen=True, kw_only=True)
class Whirl:
    """Modes of coaxial shafts in space, animated on the page; all have the same scale along z.

    `outlines` are z and radius (m,) of each shaft; where the radius changes abruptly, two
    points have the same z. `names` are the names of the shafts. `supports` are the positions z of
    bearings to ground, `links` the positions of bearings between shafts. Lengths are in `unit`.
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
    """Campbell diagram: natural frequencies (n, branches) over the speed (n,).

    Both are in the units of the labels.

    `whirl` of each branch is 1 (forward), -1 (backward) or 0 (neither). `names` are drawn at the
    ends of branches. `excitations` are lines through the origin: name and frequency per speed.
    `critical` contains speed, frequency and name of the intersections of these lines with branches.
    `peers` are speeds and frequencies (k,) by another method, which has the name `peers_name`. The
    `range` of operating speeds is shaded.
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
    """A vertical axis from `low` to `high`, in `unit`; with `log`, it is logarithmic."""

    name: str
    unit: str
    low: float
    high: float
    log: bool = False


@dataclass(frozen=True, kw_only=True)
class Parallel:
    """Plot of parameter sets as lines across vertical axes: `members` (k, axes).

    `highlighted` lines are given by row, name and colour (0 to 5); all other lines are thin.
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

    Styles: "body" (closed outline, filled), "modelled" (closed: the part that finite elements
    model), "hole" (closed, cut out), "line" (centre line of a thin body), "axis", "faint", "clamp"
    (hatched on the left of its direction), "load" (an arrow to its last point), "dimension" (arrows
    at both ends, `label` between them), "angle" (an arc with both arrows), "leader" (from the label
    to its last point) and "text" (`label` at its only point).
    """

    style: str
    points: Array
    label: str = ""


@dataclass(frozen=True, kw_only=True)
class Sketch:
    """A sketch of a case as data; `title` is its description in words."""

    title: str
    shapes: tuple[Shape, ...]


@dataclass(frozen=True, kw_only=True)
class FormulaValue:
    """A value of the formulas in its display unit.

    `judged` is True if a row compares the value with finite elements. `form` is "as printed" or
    "corrected" if a formula has several forms. `safe` is the safe side of its error, "too high" or
    "too low".
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

    @property
    def label(self) -> str:
        """Meaning of the value, with the addition "as printed" if its `form` is "as printed"."""
        return f"{self.what}, as printed" if self.form == "as printed" else self.what


@dataclass(frozen=True, kw_only=True)
class Table:
    """A table for printing; cells are texts or numbers."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str | float | None, ...], ...]
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Equation:
    """An equation as TeX, and the same equation with inserted numbers."""

    tex: str
    numbers: str = ""
    place: str = ""
    is_step: bool = False  # a number that other formulas take, not a result


@dataclass(frozen=True, kw_only=True)
class InputValue:
    """An input in its display unit."""

    name: str
    symbol: str
    what: str
    value: float | int | str
    unit: str
    source: str = ""
