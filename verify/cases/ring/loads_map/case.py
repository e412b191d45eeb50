"""Where a smeared race is good enough: its error over the number of loads and the wall."""

from collections.abc import Sequence

import numpy as np
from pydantic import model_validator

from analytic.ring.loaded_race import LoadedRace
from analytic.ring.smeared import race_deflection, smeared_error
from verify.cases.ring.loads.comparisons import AWAY, EDGE
from verify.cases.ring.loads.inputs import Wall
from verify.cases.ring.loads.reference import CELLS, ROUND, fem_sector
from verify.core.case import Case, Context, FemResult, Output, Scan, Values
from verify.core.figures import Figure, Map
from verify.core.inputs import Inputs, quantity
from verify.judging.checks import Identity

COUNTS = (3, 4, 6, 8, 10, 12, 16, 24, 32, 48)
RATIOS = (1.05, 1.1, 1.2, 1.35, 1.5, 2.0, 2.5, 3.0)
CHECKED = ((3, 1.05), (48, 1.05), (6, 1.35), (12, 1.35), (3, 3.0), (48, 3.0))
SHARP = 3e-3
ACCEPTED = "a tenth of what the map's finest shade tells apart, and better"


class MapInputs(Inputs):
    """Loads on the bore of rings of radius 1, in units of load and modulus."""

    a_r: float = quantity(
        0.008, "1", "a/r_i", "half-width of the patches over the bore's radius", ge=5e-4, le=0.015
    )
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)

    @model_validator(mode="after")
    def _narrow(self) -> "MapInputs":
        wall = min(RATIOS) - 1
        if self.a_r > 0.3 * wall:
            raise ValueError(
                f"a/r_i = {self.a_r:g} is more than 0.3 of the thinnest wall, {wall:g} r_i"
            )
        return self


def name(n: int, ratio: float) -> str:
    """How a point of the map is called."""
    return f"n = {n}, r_o/r_i = {ratio:g}"


def analytic(q: MapInputs) -> Values:
    values: dict[str, float] = {}
    for n, ratio in CHECKED:
        ring = LoadedRace(
            r_i=1.0, r_o=ratio, E=1.0, nu=q.nu, assumption="plane stress", loaded="bore", n=n,
            P=1.0, a=q.a_r,
        )  # fmt: skip
        smeared = race_deflection(P=1.0, n=n, r_i=1.0, r_o=ratio, E=1.0, nu=q.nu, loaded="bore")
        load, between = ring.at(1.0, [0.0, np.pi / n]).u_r / smeared
        values |= {f"{name(n, ratio)}: load": load, f"{name(n, ratio)}: between": between}
        error = smeared_error(n=n, ratio=ratio, a_r=q.a_r, nu=q.nu)
        values |= {f"{name(n, ratio)}: error": error.total}
    return {key: float(value) for key, value in values.items()}


def fem(q: MapInputs, level: int) -> FemResult:
    from fem.plane.material import Elastic

    values: dict[str, float] = {}
    u_it: dict[str, float] = {}
    for n, ratio in CHECKED:
        sector = fem_sector(
            r_i=1.0, r_o=ratio, n=n, loaded="bore", a=q.a_r, P=1.0,
            material=Elastic(E=1.0, nu=q.nu), level=level,
        )  # fmt: skip
        wall = n / (2 * np.pi) * ((ratio**2 + 1) / (ratio**2 - 1) + q.nu)  # under n/(2 pi)
        c, s = np.cos(np.pi / n), np.sin(np.pi / n)
        load = sector.displacement_at((1.0, 0.0))[0]
        between = float(np.dot(sector.displacement_at((c, s)), (c, s)))
        for place, u in (("load", load), ("between", between)):
            values[f"{name(n, ratio)}: {place}"] = u / wall
            u_it[f"{name(n, ratio)}: {place}"] = max(sector.residual**0.5, ROUND) * load / wall
    return FemResult(h=1 / (CELLS * level), values=values, u_it=u_it)


CHECKS = tuple(
    Identity(name=f"displacement {words}, {name(n, ratio)}", symbol="δ/δ_6", unit="1",
             fem=f"{name(n, ratio)}: {place}", analytic=f"{name(n, ratio)}: {place}",
             scale=f"{name(n, ratio)}: load", formal=EDGE if place == "load" else AWAY,
             demand=SHARP, demand_reason=ACCEPTED)
    for n, ratio in CHECKED
    for place, words in (("load", "at a load"), ("between", "between loads"))
)  # fmt: skip


PLACES = {
    "load": ("at a load, less the dent", "Eq. 6 over the Fourier ring less its dent, that of a "
             "half plane to the wall's depth"),
    "between": ("between loads", "Eq. 6 over the Fourier ring"),
    "total": ("with Hertz's dent, at a load", "Eq. 6 and the dent of a half plane to the wall's "
              "depth, over the Fourier ring"),
}  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    return tuple(
        _map(context.inputs, loaded, place) for loaded in ("bore", "rim") for place in PLACES
    )


def _map(q: MapInputs, loaded: Wall, place: str) -> Map:
    where, words = PLACES[place]
    error = np.array([
        [getattr(smeared_error(n=n, ratio=ratio, a_r=q.a_r, nu=q.nu, loaded=loaded), place)
         for n in COUNTS]
        for ratio in RATIOS
    ])  # fmt: skip
    checked = np.array([[(n, ratio) in CHECKED for n in COUNTS] for ratio in RATIOS])
    race = "outer race" if loaded == "bore" else "inner race"
    return Map(
        title=f"Error of the smeared {race} {where}", x_label="number of loads", y_label="r_o/r_i",
        columns=tuple(map(str, COUNTS)), rows=tuple(f"{ratio:g}" for ratio in RATIOS),
        error=error, checked=checked if loaded == "bore" else None,
        note=f"{words}, less one; a/r = {q.a_r:g} of the loaded wall. The mean over the wall has "
        "no error.",
    )  # fmt: skip


MAP = Case(
    id="ring-loads-map",
    title="Validity of the uniformly loaded race",
    paper="huang2018",
    place="Eq. 6 over the number of sprags and the wall",
    lead="The Fourier ring says how far Eq. 6 is off for any number of loads and any wall; finite "
    "elements at six points of the map, its corners among them, say that the Fourier ring can be "
    "trusted there.",
    inputs=MapInputs,
    analytic=analytic,
    reference=fem,
    levels=(2, 3, 5),
    scans=(
        Scan(vary=("a_r=0.004,0.008,0.016", "nu=0.2,0.3,0.4"), star=True),
    ),
    checks=CHECKS,
    outputs=tuple(
        Output(key=f"{name(n, ratio)}: error", symbol="m", unit="1",
               what=f"error of Eq. 6 and the dent at a load, {name(n, ratio)}", judged=False)
        for n, ratio in CHECKED
    ),
    readings=("thin rings (plane stress), as in Eq. 6; loads on the bore",),
    assumptions=(
        "linear elasticity, small strain, forces along radii, no friction",
        "Hertz's pressure over one half-width on every ring",
        "half a pitch with symmetry on both cuts",
    ),
    figures=figures,
)  # fmt: skip
