"""K of the polyhedral ring over number of flats, wall and fillet: where K = 1 may be trusted."""

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from pydantic import model_validator

from analytic.polyhedral import bore_pressure, expansion
from analytic.polyhedral.locking import Roller, locked
from analytic.polyhedral.sector import Sector
from verify.cases.polyhedral.fem import UNIT, factors, largest_in_fillet, pressed_fem
from verify.cases.polyhedral.inputs import PolygonRing, RoundRing
from verify.cases.polyhedral.map import figures as map_figures
from verify.cases.polyhedral.map.figures import FLATS, SHARES, WALLS
from verify.core.case import Case, Context, FemResult, Output, Scan, Values
from verify.core.figures import Figure
from verify.core.inputs import quantity
from verify.judging.checks import Accepted, Identity
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, demanded, farthest, suites

LEVELS = (1, 2, 3)
MAPPED = 2  # the level on which the whole of the maps is solved
ASKED = (0, 3, 9, 11)  # of FLATS, where the series is asked beside it
NEAR_LAME = 0.02  # of K at 48 flats
TRUE = 1e-3  # series against finite elements, all over the map
AS_MESH = "as much as halving the mesh may change"
FROM = 12  # flats from which on K falls to its limit
THICKEST = 0.15  # wall over outer diameter
PRESSED = 1.5  # of the touching pressure, for the share that reaches the rollers
ETA = 0.01  # of it, series against finite elements
DEFINITIONS = ("mid", "mean", "corner")


class MapInputs(RoundRing):
    """The ring whose flats, wall and fillet are varied; δ_1 and ρ are those of its middle."""

    rho: float = quantity("2 mm", "mm", "ρ", "fillet radius of the bore's corners", gt=0, le=1e4)
    d: float = quantity("10 mm", "mm", "d", "diameter of the rollers", gt=0, le=1e5)

    @model_validator(mode="after")
    def _varied(self) -> "MapInputs":
        thickest = min(THICKEST, 0.45 / (1 + max(SHARES)))
        if self.delta_1 > thickest * self.d_e:
            raise ValueError(
                f"the map's fillets leave no flat: δ_1 must be at most {thickest:.3g} d_e = "
                f"{thickest * self.d_e * 1e3:.4g} mm, got {self.delta_1 * 1e3:g} mm"
            )
        largest = 0.9 * (0.5 - max(WALLS)) * self.d_e
        if self.rho > largest:
            raise ValueError(
                f"fillets leave no flat in the thickest walls of the map: ρ must be at most "
                f"{largest * 1e3:.4g} mm, got {self.rho * 1e3:g} mm"
            )
        return self

    def ring(self, z: int, delta_1: float, rho: float) -> PolygonRing:
        """One ring of the map."""
        return PolygonRing(
            d_e=self.d_e, j_D=self.j_D, E=self.E, nu=self.nu, z=z, delta_1=delta_1, rho=rho
        )


Rings = list[tuple[int, float, float]]


def by_wall(q: MapInputs) -> Rings:
    """Flats, walls and the fillet of the first map, row by row."""
    return [(z, share * q.d_e, q.rho) for share in WALLS for z in FLATS]


def by_fillet(q: MapInputs) -> Rings:
    """Flats, the wall and fillets of the second map, row by row."""
    return [(z, q.delta_1, share * q.delta_1) for share in SHARES for z in FLATS]


def at_reference(q: MapInputs) -> Rings:
    """Flats with the wall and fillet of the inputs."""
    return [(z, q.delta_1, q.rho) for z in FLATS]


def sector(q: MapInputs, z: int, delta_1: float, rho: float) -> Sector:
    return Sector(z=z, d_e=q.d_e, d_i=q.d_e - 2 * delta_1, rho=rho)


def flexibility(q: MapInputs, rings: Rings) -> Any:
    """1/K (m, 3) of the middle of the flats, the mean and the corners, by the series."""
    found = []
    for z, delta_1, rho in rings:
        K = bore_pressure.stiffness_factors(
            sector=sector(q, z, delta_1, rho), nu=q.nu, assumption="plane stress"
        )
        found.append((1 / K.mid, 1 / K.mean, 1 / K.corner))
    return np.array(found)


def analytic(q: MapInputs) -> Values:
    limit = float(expansion.many_corners_factor(d_i=q.d_i, d_e=q.d_e))
    values = {"K many": limit}
    for z, (mid, mean, corner) in zip(FLATS, flexibility(q, at_reference(q)), strict=True):
        values |= {f"K mid {z}": 1 / mid, f"K mean {z}": 1 / mean, f"K corner {z}": 1 / corner}
    return values


def fem(q: MapInputs, level: int) -> FemResult:
    arrays: dict[str, Any] = {}
    if level == MAPPED:
        for name, rings in (("wall", by_wall(q)), ("fillet", by_fillet(q))):
            arrays[name] = np.array([_per_p_1(q, ring, level)[0] for ring in rings])
    if level == LEVELS[-1]:
        arrays["efficiency"] = efficiency_fem(q)
    reference = np.array([_per_p_1(q, ring, level) for ring in at_reference(q)])
    arrays["reference"] = reference[:, :3]
    arrays["fillet stress"] = reference[:, 3]
    values = {
        f"K {name} {z}": 1 / row[k]
        for z, row in zip(FLATS, reference, strict=True)
        for k, name in enumerate(DEFINITIONS)
    }
    return FemResult(h=1 / level, values=values, arrays=arrays)


def _per_p_1(q: MapInputs, ring: tuple[int, float, float], level: int) -> tuple[float, ...]:
    """1/K in the middle, the mean and at corners, and the fillets' stress over σ_t."""
    one = q.ring(*ring)
    solved = pressed_fem(one, level, "plane stress")
    thin = 2 * one.delta_1 * q.E / (one.d_i * one.d_m)  # p_1 over j_D
    u = factors(one, solved)
    p = UNIT / 2 / u["mid"]  # over j_D, where the middle of the flats has taken it up
    stress = largest_in_fillet(one, solved) * p / UNIT / (q.E / one.d_m)
    return (*(2 * thin * u[name] / UNIT for name in DEFINITIONS), stress)


def efficiency_fem(q: MapInputs) -> Any:
    """Share of further pressure that reaches the rollers, for every number of flats (m,)."""
    from verify.cases.polyhedral.locking.fem import LockedRing

    found = []
    for ring in at_reference(q):
        one = q.ring(*ring)
        p = PRESSED * touching(q, ring)
        contact = LockedRing(one, 1, d=roller(q, one.z), e=0.5 * one.half_flat, p=p)
        low, high = (contact.force(k * p) for k in (0.9, 1.1))
        found.append((high - low) / (0.2 * p * one.d_i * np.sin(one.half_angle)))
    return np.array(found)


def touching(q: MapInputs, ring: tuple[int, float, float]) -> float:
    """Pressure [Pa] of the thin ring that takes up the clearance, for the size of loads."""
    return 2 * ring[1] * q.E * q.j_D / ((q.d_e - 2 * ring[1]) * (q.d_e - ring[1]))


def roller(q: MapInputs, z: int) -> float:
    """Diameter [m] of the rollers, those of the inputs where so many fit."""
    sine = float(np.sin(np.pi / z))
    return min(q.d, 0.9 * (q.d_e + q.j_D) * sine / (1 - sine))


@lru_cache(maxsize=4)
def efficiency(q: MapInputs) -> Any:
    """The same by the series."""
    found = []
    for z, delta_1, rho in at_reference(q):
        state = locked(
            sector=sector(q, z, delta_1, rho), roller=Roller(d=roller(q, z), j_D=q.j_D),
            p=PRESSED * touching(q, (z, delta_1, rho)), E=q.E, nu=q.nu, assumption="plane stress",
        )  # fmt: skip
        found.append(state.efficiency)
    return np.array(found)


def on_map(context: Context, name: str) -> Any:
    """1/K of finite elements on a map (m,), row by row; None without them."""
    return next((r.arrays[name] for r in context.fem if name in r.arrays), None)


def true(name: str, rings: Callable[[MapInputs], Rings]) -> Callable[[Context], Pair]:
    """Series and finite elements where they differ most over a map, as 1/K.

    The series is asked in some of the cells: a third of the flats in every other row. How much a
    finer mesh changes is known for the rings of the middle.
    """

    def pair(context: Context) -> Pair:
        cells = np.arange(len(rings(context.inputs))).reshape(-1, len(FLATS))[::2, ASKED].ravel()
        asked = [rings(context.inputs)[cell] for cell in cells]
        series = flexibility(context.inputs, asked)[:, 0]
        middle = [r.arrays["reference"][:, 0] for r in context.fem[-2:]]
        u = float(3 * np.abs(middle[1] / middle[0] - 1).max())
        return farthest(series, on_map(context, name)[cells], u)

    return pair


def kept(context: Context) -> Pair:
    """The shares of series and FE where they differ most."""
    return farthest(efficiency(context.inputs), context.fem[-1].arrays["efficiency"], 0.0)


def falls(context: Context) -> tuple[float, float, str]:
    """Least step of |K_mid - K_∞| from one number of flats to the next, from 12 on."""
    limit = context.analytic["K many"]
    over = [z for z in FLATS if z >= FROM]
    on = [
        np.array([abs(level.values[f"K mid {z}"] - limit) for z in over]) for level in context.fem
    ]
    step, U = float(-np.diff(on[-1]).max()), float(6 * np.abs(on[-1] - on[-2]).max())
    return step, U, f"{step:.2g} at least from one number of flats to the next"


def near_lame(context: Context) -> Pair:
    """Lamé's limit and K of 48 flats."""
    limit, K = context.analytic["K many"], context.series(f"K mid {FLATS[-1]}")[1]
    return Pair(limit, K[-1], 3 * abs(K[-1] - K[-2]), f"{K[-1] / limit - 1:+.2%}")


def draws_in(context: Context) -> tuple[float, float, str]:
    """How far the corners of three flats draw in: minus 1/K there."""
    K = context.series(f"K corner {FLATS[0]}")[1]
    return -1 / K[-1], 3 * abs(1 / K[-1] - 1 / K[-2]), f"K_corner is {K[-1]:.4g}"


CHECKS = (
    *(
        Identity(name=f"K of {z} flats, middle", symbol="K_mid", unit="1", fem=f"K mid {z}",
                 analytic=f"K mid {z}", formal=4, demand=1e-3,
                 demand_reason="acceptance figure: 0.1 % under halving of the mesh")
        for z in FLATS
    ),
    Agreement(name="K of 48 flats is within 2 % of Lamé's limit", symbol="K", unit="1",
              pair=near_lame, accepted=NEAR_LAME,
              source=SUBJECT, **demanded(NEAR_LAME)),
    Accepted(name="K approaches Lamé's limit steadily from 12 flats on", symbol="K - K_∞",
             unit="1", margin=falls),
    Accepted(name="corners of three flats draw in under pressure", symbol="K_corner", unit="1",
             margin=draws_in),
    Agreement(name="series and FE agree to 0.1 % over flats and walls", symbol="1/K_mid", unit="1",
              pair=true("wall", by_wall), accepted=TRUE,
              source=suites(AS_MESH), everywhere=True),
    Agreement(name="series and FE agree to 0.1 % over flats and fillets", symbol="1/K_mid",
              unit="1", pair=true("fillet", by_fillet), accepted=TRUE,
              source=suites(AS_MESH), everywhere=True),
    Agreement(name="series and FE agree to 1 % in the share that reaches the rollers", symbol="η",
              unit="1", pair=kept, accepted=ETA,
              source=suites("as far off as rows may be"), everywhere=True, **demanded(ETA)),
)  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    """The maps by finite elements, or where there are none by the series."""
    q = context.inputs
    wall, fillet = (
        flexibility(q, rings(q))[:, 0] if found is None else found
        for rings, found in ((by_wall, on_map(context, "wall")),
                             (by_fillet, on_map(context, "fillet")))
    )  # fmt: skip
    return map_figures.figures(
        context, wall, fillet, flexibility(q, at_reference(q)), efficiency(q)
    )


MAP = Case(
    id="polyhedral-map",
    title="K of the polyhedral ring over flats, wall and fillet",
    paper="belcin",
    place="K before Eq. 11; Eqs. 13 and 16",
    lead="Where the paper's K = 1 may be trusted, and where its roller force: from 3 to 48 flats, "
    "over walls and fillets. Finite elements solve every cell of the maps, the series stands "
    "beside them. Sizes are the project's.",
    inputs=MapInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("delta_1=3mm,4mm", "rho=2mm,3mm"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        Output(key="K many", symbol="K_∞", unit="1", what="K of ever more flats (Lamé)",
               judged=False),
        *(
            Output(key=f"K mid {z}", symbol="K_mid", unit="1", what=f"K of {z} flats")
            for z in FLATS
        ),
    ),
    readings=(
        "d_i is the diameter through the corners as they are: the wall in the corners stays the "
        "same from map to map, the wall above the flats grows as flats become fewer",
    ),
    assumptions=("linear elasticity, small strain, plane stress", "half a sector of each ring"),
    figures=figures,
)  # fmt: skip
