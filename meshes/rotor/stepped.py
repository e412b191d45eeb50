"""Half-sections of stepped shafts, fine at the corners of every step."""

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from skfem import MeshQuad1

from meshes.counts import nearest
from meshes.revolution.section import chain, stations

Array = NDArray[np.float64]
Part = tuple[float, float, float]  # length, outer diameter, bore
SAME = 1e-9  # relative to the shaft's length


def stepped_section(
    parts: Sequence[Part],
    *,
    bands: Mapping[str, tuple[float, float]] | None = None,
    first: float,
    growth: float = 2.0,
    refine: int = 1,
) -> MeshQuad1:
    """Mesh of rectangular cells in a shaft of `parts` (length, d_o, d_i) from z = 0, end to end.

    Cells are at most `first` long at the corners of steps, and larger at a distance from them;
    `refine` divides the size of all cells. All lengths have the same unit. Boundaries: "rim" and
    "bore" of all parts, "axis", "start", "end", and each of the `bands` (from, to) on the rim.
    Body: "body". Raises ValueError unless lengths are positive, 0 <= d_i < d_o, the sections of
    neighbouring parts overlap, and bands lie on the shaft.
    """
    _check(parts)
    z = np.cumsum([0.0, *(length for length, _, _ in parts)])
    radii = sorted({d / 2 for _, *both in parts for d in both})
    steps = [z[k] for k in range(1, len(parts)) if parts[k][1:] != parts[k - 1][1:]]
    bands = {name: _on(z, band) for name, band in (bands or {}).items()}
    edges = [end for band in bands.values() for end in band]
    along = _graded(sorted({*z.tolist(), *edges}), set(steps), first, growth, refine)
    corners = {r for a, b in pairwise(parts) for d, e in zip(a[1:], b[1:], strict=True)
               if d != e for r in (d / 2, e / 2)}  # fmt: skip
    across = _graded(radii, corners - {0.0}, first, growth, refine)
    mesh = MeshQuad1.init_tensor(across, along)
    r, middle = mesh.p[:, mesh.t].mean(axis=1)
    part = np.searchsorted(z, middle) - 1
    outer, inner = (np.array([p[k] / 2 for p in parts])[part] for k in (1, 2))
    mesh = mesh.remove_elements(np.flatnonzero((r > outer) | (r < inner)))
    return _named(mesh, z, bands)


def _graded(
    points: Sequence[float], fine: set[float], first: float, growth: float, refine: int
) -> Array:
    """Stations through all `points`, with cells of the size `first` at the `fine` points."""
    return chain([_between(a, b, fine, first, growth, refine) for a, b in pairwise(points)])


def _between(
    a: float, b: float, fine: set[float], first: float, growth: float, refine: int
) -> Array:
    """Stations from a to b: fine cells at each fine end; equal cells if neither end is fine."""
    if a in fine and b in fine:
        middle = (a + b) / 2
        own = {a, b}
        return chain([_between(a, middle, own, first, growth, refine),
                      _between(middle, b, own, first, growth, refine)])  # fmt: skip
    if not fine & {a, b}:
        return np.linspace(a, b, refine * max(1, nearest((b - a) / (8 * first))) + 1)
    start, end = (a, b) if a in fine else (b, a)
    size = min(first, b - a)
    return stations(start=start, end=end, first=size, growth=growth, refine=refine)


def _on(z: Array, band: tuple[float, float]) -> tuple[float, float]:
    """The band; an end that differs from the end of a part by round-off is moved to that end."""
    if not 0 <= band[0] < band[1] <= z[-1] * (1 + SAME):
        raise ValueError(
            f"a band must lie on the shaft: 0 <= low < high <= {z[-1]:g} m, got {band}"
        )
    low, high = (
        float(z[k]) if abs(z[k] - end) <= SAME * z[-1] else end
        for end in band
        for k in (int(np.argmin(abs(z - end))),)
    )
    return low, high


def _named(mesh: MeshQuad1, z: Array, bands: Mapping[str, tuple[float, float]]) -> MeshQuad1:
    """Mesh with boundaries named by the position of facets."""
    outside = mesh.boundary_facets()
    ends = mesh.p[:, mesh.facets[:, outside]]
    r, at = ends.mean(axis=1)
    upright = np.ptp(ends[1], axis=0) == 0
    inside = mesh.p[0, mesh.t[:, mesh.f2t[0, outside]]].mean(axis=0)
    rim, bore = ~upright & (inside < r), ~upright & (inside > r)
    found = {
        "rim": rim, "bore": bore & (r > 0), "axis": bore & (r == 0),
        "start": upright & (at == 0), "end": upright & (at == z[-1]),
    }  # fmt: skip
    found |= {name: rim & (low < at) & (at < high) for name, (low, high) in bands.items()}
    named = {name: outside[chosen] for name, chosen in found.items() if np.any(chosen)}
    return mesh.with_boundaries(named).with_subdomains({"body": np.arange(mesh.nelements)})


def _check(parts: Sequence[Part]) -> None:
    for length, d_o, d_i in parts:
        if not (0 < length < np.inf and 0 <= d_i < d_o < np.inf):
            raise ValueError(
                "a part must have length > 0 and 0 <= d_i < d_o, got "
                f"length={length:g} m, d_o={d_o:g} m, d_i={d_i:g} m"
            )
    if not parts:
        raise ValueError("a shaft must have at least one part, got none")
    for a, b in pairwise(parts):
        if not max(a[2], b[2]) < min(a[1], b[1]):
            raise ValueError(
                "the sections of neighbouring parts must overlap, got "
                f"d_o={a[1]:g}, d_i={a[2]:g} m and d_o={b[1]:g}, d_i={b[2]:g} m"
            )
