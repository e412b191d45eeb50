"""Case that maps the error of Eq. 6 over the number of sprags and the wall thickness."""

from collections.abc import Iterator, Mapping
from typing import ClassVar, NamedTuple, Self

import numpy as np
from pydantic import model_validator

from analytic.ring.loaded_race import LoadedRace
from analytic.ring.smeared import race_deflection, smeared_error
from verify.case import Case, Comparison, Drawn, Level, Quantity, Scan, given, identity, shared
from verify.cases.ring.loads.comparisons import AWAY, EDGE, PATCHES
from verify.cases.ring.loads.inputs import Wall
from verify.cases.ring.loads.reference import CELLS, ROUND, fem_sector
from verify.core.figures import Array, Map
from verify.form.adapter import adapted

COUNTS = (3, 4, 6, 8, 10, 12, 16, 24, 32, 48)
RATIOS = (1.05, 1.1, 1.2, 1.35, 1.5, 2.0, 2.5, 3.0)
SHARP = (
    3e-3,
    "this sensitivity is a tenth of the smallest interval between two colour limits of the map",
)


class Point(NamedTuple):
    """A race of the map: number of sprags n, and ratio of outer to inner radius r_o/r_i."""

    n: int
    ratio: float

    def __str__(self) -> str:
        return f"{self.n}_{self.ratio:g}".replace(".", "_")

    @property
    def words(self) -> str:
        """Name of the point in rows."""
        return f"n = {self.n}, r_o/r_i = {self.ratio:g}"


CHECKED = tuple(
    Point(*at) for at in ((3, 1.05), (48, 1.05), (6, 1.35), (12, 1.35), (3, 3.0), (48, 3.0))
)
PLACES = {
    "load": ("under a sprag, without indentation", "δ_6/(δ − δ_H) − 1, with δ_6 by Eq. 6, the "
             "deflection δ under a sprag by the Fourier series of the ring, and the indentation "
             "δ_H of a half-plane (relative to a point one wall thickness deep)"),
    "between": ("between sprags", "δ_6/δ − 1, with δ_6 by Eq. 6 and the deflection δ between "
                "sprags by the Fourier series of the ring"),
    "total": ("with Hertz's indentation, under a sprag", "(δ_6 + δ_H)/δ − 1, with δ_6 by Eq. 6, "
              "the deflection δ under a sprag by the Fourier series of the ring, and the "
              "indentation δ_H of a half-plane (relative to a point one wall thickness deep)"),
}  # fmt: skip


class LoadsMap(Case):
    """The Fourier series of a ring gives the error of Eq. 6 for any number of sprags and any wall.

    Finite elements confirm the series at six points of the map, including its corners. Bore
    radius, load per length and Young's modulus are 1.
    """

    id = "ring-loads-map"
    title = "Validity of the model of a uniformly loaded race"
    source = "huang2018"
    place = "Eq. 6 over number of sprags and wall thickness"
    levels: ClassVar = (2, 3, 5)
    scans: ClassVar = (Scan(vary=("a_r=0.004,0.008,0.016", "nu=0.2,0.3,0.4"), star=True),)
    readings: ClassVar = (
        "the rings are axially short (plane stress), as in Eq. 6; in the rows, the sprags load the "
        "bore, and δ_6 is the displacement by Eq. 6",
    )
    assumptions: ClassVar = (
        "linear elasticity, small strain, radial forces, no friction",
        "Hertz's pressure acts on patches of equal half-width on all rings",
        "half a pitch is modelled, with symmetry on both cuts",
    )

    a_r: float = given(
        0.008,
        "1",
        "a/r_i",
        "ratio of the half-width of the contact patches to the bore radius",
        ge=5e-4,
        le=0.015,
    )
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)

    @model_validator(mode="after")
    def _narrow(self) -> Self:
        wall = min(RATIOS) - 1
        if self.a_r > 0.3 * wall:
            raise ValueError(
                f"a/r_i must be at most {0.3 * wall:g}, 0.3 times the thinnest wall {wall:g} r_i, "
                f"got {self.a_r:g}"
            )
        return self

    @Quantity("δ(0; {0.n}, {0.ratio:g})/δ_6", "1",
              "displacement under a sprag, divided by δ_6, {0.words}",
              source="Fourier series of the ring, divided by Eq. 6").over(CHECKED)  # fmt: skip
    def load(self, at: Point) -> float:
        return float(self._over_eq_6[at][0])

    @Quantity("δ(π/n; {0.n}, {0.ratio:g})/δ_6", "1",
              "displacement between sprags, divided by δ_6, {0.words}",
              source="Fourier series of the ring, divided by Eq. 6").over(CHECKED)  # fmt: skip
    def between(self, at: Point) -> float:
        return float(self._over_eq_6[at][1])

    @Quantity("m({0.n}, {0.ratio:g})", "1",
              "error of δ_6 + δ_H relative to the displacement under a sprag, {0.words}",
              role="step").over(CHECKED)  # fmt: skip
    def error(self, at: Point) -> float:
        return float(smeared_error(n=at.n, ratio=at.ratio, a_r=self.a_r, nu=self.nu).total)

    @shared
    def _over_eq_6(self) -> Mapping[Point, Array]:
        """Ratios of the displacements under and between sprags to that by Eq. 6, by point."""
        found = {}
        for at in CHECKED:
            ring = LoadedRace(
                r_i=1.0, r_o=at.ratio, E=1.0, nu=self.nu, assumption="plane stress",
                loaded="bore", n=at.n, P=1.0, a=self.a_r,
            )  # fmt: skip
            smeared = race_deflection(
                P=1.0, n=at.n, r_i=1.0, r_o=at.ratio, E=1.0, nu=self.nu, loaded="bore"
            )
            found[at] = np.asarray(ring.at(1.0, [0.0, np.pi / at.n]).u_r / smeared)
        return found

    def reference(self, level: int) -> Level:
        """Results of half a pitch at every checked point."""
        from fem.plane.material import Elastic

        values, u_it = {}, {}
        for at in CHECKED:
            n, ratio = at
            sector = fem_sector(
                r_i=1.0, r_o=ratio, n=n, loaded="bore", a=self.a_r, P=1.0,
                material=Elastic(E=1.0, nu=self.nu), level=level,
            )  # fmt: skip
            # under n/(2 pi)
            wall = n / (2 * np.pi) * ((ratio**2 + 1) / (ratio**2 - 1) + self.nu)
            c, s = np.cos(np.pi / n), np.sin(np.pi / n)
            load = sector.displacement_at((1.0, 0.0))[0]
            between = float(np.dot(sector.displacement_at((c, s)), (c, s)))
            for place, u in (("load", load), ("between", between)):
                values[f"{place}_{at}"] = u / wall
                u_it[f"{place}_{at}"] = max(sector.residual**0.5, ROUND) * load / wall
        return Level(h=1 / (CELLS * level), values=values, u_it=u_it)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: Fourier series against finite elements at every checked point."""
        for at in CHECKED:
            scale = {f"displacement under a sprag, divided by δ_6, {at.words}": self.load(at)}
            for q, order in ((LoadsMap.load(at), EDGE), (LoadsMap.between(at), AWAY)):
                yield identity(q, symbol="δ/δ_6", scale=scale, order=order, sensitivity=SHARP,
                               shares=PATCHES)  # fmt: skip

    def figures(self) -> Iterator[Drawn]:
        """Figures: maps of three errors of Eq. 6 for both races."""
        walls: tuple[Wall, ...] = ("bore", "rim")
        yield Drawn(lambda _: [self._map(loaded, place) for loaded in walls for place in PLACES])

    def _map(self, loaded: Wall, place: str) -> Map:
        where, words = PLACES[place]
        error = np.array([
            [getattr(smeared_error(n=n, ratio=ratio, a_r=self.a_r, nu=self.nu, loaded=loaded),
                     place) for n in COUNTS]
            for ratio in RATIOS
        ])  # fmt: skip
        checked = np.array([[(n, ratio) in CHECKED for n in COUNTS] for ratio in RATIOS])
        race = "outer race" if loaded == "bore" else "inner race"
        return Map(
            title=f"Error of Eq. 6, {race}, {where}", x_label="number of sprags",
            y_label="r_o/r_i", columns=tuple(map(str, COUNTS)),
            rows=tuple(f"{ratio:g}" for ratio in RATIOS), error=error,
            checked=checked if loaded == "bore" else None,
            note=f"Error: {words}. "
            f"a/r = {self.a_r:g}, with the radius r of the loaded surface. Eq. 6 gives "
            "the mean deflection of this surface exactly.",
        )  # fmt: skip


MAP = adapted(LoadsMap)
