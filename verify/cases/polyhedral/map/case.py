"""Case that maps K over number of flats, wall and fillet: range of validity of K = 1."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, ClassVar

import numpy as np

from analytic.contact.checks import Assumption
from analytic.polyhedral import bore_pressure, expansion
from analytic.polyhedral.locking import Roller, locked
from analytic.polyhedral.sector import Sector
from verify.case import Comparison, Drawn, Level, Quantity, Scan, identity, shared
from verify.cases.polyhedral.map import figures as drawn
from verify.cases.polyhedral.map import reference as fem
from verify.cases.polyhedral.map.inputs import FLATS, PRESSED, MapInputs, Size
from verify.core.case import Check, Context
from verify.core.figures import Array
from verify.form.adapter import adapted
from verify.judging.checks import Accepted
from verify.judging.tolerance_checks import SUBJECT, Agreement, Pair, demanded, farthest, suites

ASKED = (0, 3, 9, 11)  # indices of FLATS for which the maps contain the series
NEAR_LAME = 0.02  # tolerance of K at 48 flats
TRUE = 1e-3  # series against finite elements, all over the map
AS_MESH = "equal to the accepted change when the cell size is halved"
HALVED = 1e-3, "accepted change when the cell size is halved: 0.1 %"
FROM = 12  # K falls to its limit from this number of flats
ETA = 0.01  # tolerance of the load-transfer ratio, series against finite elements
PLANE: Assumption = "plane stress"


class PolyhedralMap(MapInputs):
    """The error of K = 1 is mapped over number of flats, wall thickness and fillet radius.

    For numbers of flats from 3 to 48, the part of a pressure increase that the rollers carry is
    also computed; the paper assigns the whole increase to the rollers. All rings are solved with
    finite elements, and a part of them also with the series. Dimensions are assumed.
    """

    id = "polyhedral-map"
    title = "Correction factor K for varied number of flats, wall thickness and fillet radius"
    source = "belcin"
    place = "K before Eq. 11; Eqs. 13 and 16"
    levels: ClassVar = fem.LEVELS
    scans: ClassVar = (Scan(vary=("delta_1=3mm,4mm", "rho=2mm,3mm"), star=True),)
    readings: ClassVar = (
        "d_i is the diameter of the circle that touches the fillets in the corners of the bore. "
        "Therefore, "
        "the wall in the corners is equal for all numbers of flats, and the wall above the flats "
        "is thicker if the ring has fewer flats",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain, plane stress", "half a sector of each ring is modelled",
    )  # fmt: skip

    @Quantity("K_∞", "1", "limit of K for many flats", source="Lamé", role="step",
              tex=r"\frac{(d_e - \delta_1)^2}{d_i d_e}")  # fmt: skip
    def K_many(self) -> float:
        return float(expansion.many_corners_factor(d_i=self.d_i, d_e=self.d_e))

    @Quantity("K_{0}", "1", "K in the middle of the flats, z = {0}",
              source="complex potentials").over(FLATS)  # fmt: skip
    def K_mid(self, z: int) -> float:
        return float(1 / self.flexible_middle[FLATS.index(z), 0])

    @shared
    def flexible_middle(self) -> Array:
        """Array (flats, 3) of 1/K by its three definitions, for all numbers of flats (series)."""
        return self.flexibility(self.at_middle)

    @shared
    def efficiency(self) -> Array:
        """Fraction of a pressure increment that the rollers carry, by the series, (flats,)."""
        return np.array([
            locked(
                sector=self.sector(size), roller=Roller(d=self.roller(size[0]), j_D=self.j_D),
                p=PRESSED * self.touching(size[1]), E=self.E, nu=self.nu, assumption=PLANE,
            ).efficiency
            for size in self.at_middle
        ])  # fmt: skip

    def sector(self, size: Size) -> Sector:
        """Geometry of half a sector of a ring of the map, for the series."""
        z, delta_1, rho = size
        return Sector(z=z, d_e=self.d_e, d_i=self.d_e - 2 * delta_1, rho=rho)

    def flexibility(self, rings: Sequence[Size]) -> Array:
        """1/K (rings, 3) by the series, from the middle, mean and corner displacement of a flat."""
        found = (
            bore_pressure.stiffness_factors(sector=self.sector(size), nu=self.nu, assumption=PLANE)
            for size in rings
        )
        return np.array([(1 / K.mid, 1 / K.mean, 1 / K.corner) for K in found])

    def reference(self, level: int) -> Level:
        """Results of half a sector of each ring."""
        return fem.solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows: K for the wall and fillet of the inputs, limiting values of K, and both maps."""
        case = PolyhedralMap
        for z in FLATS:
            yield identity(case.K_mid(z), symbol="K_mid", order=4, sensitivity=HALVED,
                           shares=PLANE)  # fmt: skip
        yield Comparison(check=Agreement(
            name="K of a ring with 48 flats is within 2 % of the limit for many flats", symbol="K",
            unit="1",
            pair=near_lame, accepted=NEAR_LAME, source=SUBJECT, **demanded(NEAR_LAME),
        ), quantity=case.K_many, shares=PLANE)  # fmt: skip
        yield Comparison(check=Accepted(
            name="|K − K_∞| decreases with the number of flats, from 12 flats on",
            symbol="K - K_∞", unit="1",
            margin=falls,
        ), quantity=case.K_many, shares=PLANE)  # fmt: skip
        yield Accepted(name="corners of a ring with three flats move inwards under pressure",
                       symbol="K_corner", unit="1", margin=draws_in)  # fmt: skip
        more: dict[str, Any] = {"unit": "1", "everywhere": True, "shares": PLANE}
        for name, words in (("wall", "wall thickness"), ("fillet", "fillet radius")):
            yield Agreement(name="1/K by series and FE agrees within 0.1 % for varied number of "
                            f"flats and {words}",
                            symbol="1/K_mid", pair=over_map(name), accepted=TRUE,
                            source=suites(AS_MESH), **more)  # fmt: skip
        yield Agreement(
            name="incremental load-transfer ratio by series and by FE agrees within 1 %",
            symbol="η",
            pair=shares, accepted=ETA,
            source=suites("equal to the default required sensitivity of a row"),
            **demanded(ETA), **more,
        )  # fmt: skip

    def figures(self) -> Iterator[Drawn]:
        """Figures: map of the error of the assumption K = 1; K and load-transfer ratio over z."""
        yield Drawn(lambda context: drawn.figures(self, context))


def over_map(name: str) -> Callable[[Context], Pair]:
    """Function that returns a pair: 1/K by series and by finite elements where they differ most.

    The series is evaluated for a third of the numbers of flats, in every second row of the map. The
    uncertainty is that of the rings with wall and fillet of the inputs.
    """

    def pair(context: Context) -> Pair:
        rings = getattr(context.inputs, f"by_{name}")
        cells = np.arange(len(rings)).reshape(-1, len(FLATS))[::2, ASKED].ravel()
        series = context.inputs.flexibility([rings[cell] for cell in cells])[:, 0]
        solved = drawn.on_map(context, name)
        assert solved is not None
        middle = [r.arrays["reference"][:, 0] for r in context.fem[-2:]]
        u = float(3 * np.abs(middle[1] / middle[0] - 1).max())
        return farthest(series, solved[cells], u)

    return pair


def shares(context: Context) -> Pair:
    """Load-transfer ratios by series and finite elements, for the z at which they differ most."""
    return farthest(context.inputs.efficiency, context.fem[-1].arrays["efficiency"], 0.0)


def falls(context: Context) -> tuple[float, float, str]:
    """Smallest decrease of |K_mid - K_∞| between successive numbers of flats, from 12 flats on.

    The uncertainty and the text of the row are also returned.
    """
    limit, over = context.inputs.K_many, [z for z in FLATS if z >= FROM]
    on = [
        np.array([abs(level.values[f"K_mid_{z}"] - limit) for z in over]) for level in context.fem
    ]
    step, U = float(-np.diff(on[-1]).max()), float(6 * np.abs(on[-1] - on[-2]).max())
    return (
        step,
        U,
        f"|K − K_∞| decreases by at least {step:.2g} from each computed number of flats to the "
        "next",
    )


def near_lame(context: Context) -> Pair:
    """Pair: Lamé's limit of K, and K of a ring with 48 flats."""
    limit, K = context.inputs.K_many, context.series(f"K_mid_{FLATS[-1]}")[1]
    return Pair(
        limit, K[-1], 3 * abs(K[-1] - K[-2]), f"deviation {K[-1] / limit - 1:+.2%} from the limit"
    )


def draws_in(context: Context) -> tuple[float, float, str]:
    """Value -1/K_corner of a ring with three flats; positive if the corners move inwards.

    The uncertainty and the text of the row are also returned.
    """
    K = context.series(f"K_corner_{FLATS[0]}")[1]
    return -1 / K[-1], 3 * abs(1 / K[-1] - 1 / K[-2]), f"K_corner is {K[-1]:.4g}"


MAP = adapted(PolyhedralMap)
