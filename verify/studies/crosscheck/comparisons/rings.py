"""Rings under pressure, sprag forces or rotation, and polyhedral rings, compared with calculix."""

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.polyhedral.fem import (
    ARC,
    UNIT,
    factors_fem,
    in_fillet_fem,
    pressed_fem,
    pushed_fem,
)
from verify.cases.polyhedral.ring.case import RING
from verify.cases.polyhedral.ring.reference import stiffness
from verify.cases.ring.lame.case import LAME
from verify.cases.ring.loads.case import INNER, OUTER
from verify.cases.ring.loads.inputs import Wall
from verify.cases.ring.loads.reference import fem_sector
from verify.cases.ring.rotation.case import ROTATION
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.comparisons.plane import (
    AVERAGED,
    LINEAR,
    MESH,
    Fields,
    hoop,
    outwards,
    posed,
)
from verify.studies.crosscheck.statement import CALCULIX, Cross, Numbers, Posed, Quantity

if TYPE_CHECKING:
    from fem.plane.material import Assumption
    from fem.plane.solution import PlaneSolution

FINE = 6  # of the case's meshes
NODAL = "calculix extrapolates stresses to the nodes and averages them there"


def lame(assumption: "Assumption") -> Posed:
    """A thick ring with pressure in the bore and on the rim; calculix integrates the pressure."""
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.ring.quarter import quarter_ring
    from verify.studies.crosscheck.calculix.plane import PlaneDeck

    q: Any = LAME.inputs()
    steel, loads = Elastic(E=q.E, nu=q.nu), {"bore": q.p_i, "rim": q.p_o}
    mesh = quarter_ring(r_i=q.r_i, r_o=q.r_o, refine=FINE)
    ring, seconds = timed(lambda: solve_plane(
        mesh, materials=steel, assumption=assumption, supports={"x=0": "x", "y=0": "y"},
        pressures=loads,
    ))  # fmt: skip
    deck = PlaneDeck(solution=ring, materials=steel, assumption=assumption, pressures=loads)

    def moved(solution: "PlaneSolution") -> dict[str, float]:
        return {name: outwards(solution, name) for name in ("bore", "rim")}

    ours = moved(ring) | {"U": 4 * ring.strain_energy} | {
        f"hoop {name}": hoop(ring, name) for name in ("bore", "rim")
    }  # fmt: skip

    def read(fields: Fields) -> Numbers:
        own = {f"hoop {name}": fields.hoop(name) for name in ("bore", "rim")}
        return moved(fields.solution) | {"U": 4 * fields.energy} | own

    return posed(deck, ours, seconds, read)


def lame_quantities(assumption: str) -> tuple[Quantity, ...]:
    u: Any = {"symbol": "u_r", "unit": "µm", "allowed": LINEAR, "why": MESH}
    s: Any = {"symbol": "σ_θ", "unit": "MPa", "allowed": AVERAGED, "why": NODAL}
    return (
        Quantity(name="bore", row=f"bore displacement, {assumption}", **u),
        Quantity(name="rim", row=f"rim displacement, {assumption}", **u),
        Quantity(name="U", row=f"strain energy, {assumption}", symbol="U", unit="J/m",
                 allowed=LINEAR, why=MESH),
        Quantity(name="hoop bore", row=f"bore hoop stress, {assumption}", **s),
        Quantity(name="hoop rim", row=f"rim hoop stress, {assumption}", **s),
    )  # fmt: skip


def rotation() -> Posed:
    """A rotating race; calculix integrates the centrifugal forces."""
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.ring.quarter import quarter_ring
    from verify.studies.crosscheck.calculix.plane import PlaneDeck, Spin

    q: Any = ROTATION.inputs()
    steel, pull = Elastic(E=q.E, nu=q.nu), q.rho * q.omega**2
    mesh = quarter_ring(r_i=q.r_i, r_o=q.r_o, refine=FINE)
    race, seconds = timed(lambda: solve_plane(
        mesh, materials=steel, assumption="plane stress", supports={"x=0": "x", "y=0": "y"},
        body_forces=lambda x: pull * x,
    ))  # fmt: skip
    deck = PlaneDeck(
        solution=race, materials=steel, assumption="plane stress",
        spin=Spin(rho=q.rho, omega=q.omega),
    )  # fmt: skip

    def moved(solution: "PlaneSolution") -> dict[str, float]:
        return {name: outwards(solution, name) for name in ("bore", "rim")}

    ours = moved(race) | {"hoop bore": hoop(race, "bore"), "U": 4 * race.strain_energy}

    def read(fields: Fields) -> Numbers:
        return moved(fields.solution) | {"hoop bore": fields.hoop("bore"), "U": 4 * fields.energy}

    return posed(deck, ours, seconds, read)


def sprags(loaded: Wall) -> Posed:
    """Half a pitch of a race under sprag forces, guided on both cuts, one of which is inclined."""
    from fem.plane.material import Elastic
    from fem.plane.patch import polar_nodes
    from verify.studies.crosscheck.calculix.plane import PlaneDeck

    q: Any = (OUTER if loaded == "bore" else INNER).inputs()
    steel = Elastic(E=q.E, nu=q.nu)
    sector, seconds = timed(lambda: fem_sector(
        r_i=q.r_i, r_o=q.r_o, n=q.n, loaded=q.loaded, a=q.half_width, P=q.P, material=steel, level=3
    ))  # fmt: skip
    deck = PlaneDeck(solution=sector, materials=steel, assumption="plane stress")
    sign, far = (1.0, "rim") if loaded == "bore" else (-1.0, "bore")

    def moved(solution: "PlaneSolution") -> dict[str, float]:
        near, other = (sign * polar_nodes(solution, name)[1] for name in (loaded, far))
        return {
            "load": float(near[0]), "between": float(near[-1]), "far load": float(other[0]),
            "far between": float(other[-1]), "mean": sign * outwards(solution, loaded),
        }  # fmt: skip

    ours = moved(sector) | {"U": 2 * q.n * sector.strain_energy}
    return posed(
        deck, ours, seconds, lambda f: moved(f.solution) | {"U": 2 * q.n * f.energy}
    )  # fmt: skip


def sprags_quantities(loaded: str, far: str) -> tuple[Quantity, ...]:
    u: Any = {"unit": "µm", "allowed": LINEAR, "why": MESH}
    return (
        Quantity(name="load", row=f"{loaded} displacement under a sprag", symbol="δ(0)", **u),
        Quantity(name="between", row=f"{loaded} displacement between sprags", symbol="δ(π/n)", **u),
        Quantity(name="far load", row=f"{far} displacement at the angle of a sprag",
                 symbol="u_r(0)", **u),
        Quantity(name="far between", row=f"{far} displacement between sprags", symbol="u_r(π/n)",
                 **u),
        Quantity(name="mean", row=f"{loaded} displacement, mean", symbol="δ", **u),
        Quantity(name="U", row="strain energy of the race", symbol="U", unit="J/m",
                 allowed=LINEAR, why=MESH),
    )  # fmt: skip


def polyhedral(assumption: "Assumption") -> Posed:
    """Half a sector of the polyhedral ring under pressure, guided on both cuts."""
    from fem.plane.material import Elastic
    from verify.studies.crosscheck.calculix.plane import PlaneDeck

    q: Any = RING.inputs()
    ring, seconds = timed(lambda: pressed_fem(q, 3, assumption, ARC))
    deck = PlaneDeck(
        solution=ring, materials=Elastic(E=q.E, nu=q.nu), assumption=assumption,
        pressures={"bore": UNIT},
    )  # fmt: skip

    def read(solution: "PlaneSolution") -> dict[str, float]:
        per = stiffness(q, factors_fem(q, solution))
        take_up = UNIT * q.j_D / 2 / factors_fem(q, solution)["mid"]
        return per | {"fillet": in_fillet_fem(q, solution) * take_up / UNIT}

    return posed(deck, read(ring), seconds, lambda fields: read(fields.solution))


def hub(corner: bool) -> Posed:
    """Half a sector of the polyhedral ring; the hub's force acts at distance e or at the corner."""
    from fem.plane.material import Elastic
    from fem.plane.sectors import radial
    from verify.studies.crosscheck.calculix.plane import PlaneDeck

    q: Any = RING.inputs()
    (at, in_corner), seconds = timed(lambda: pushed_fem(q, 3))
    ring = in_corner if corner else at
    deck = PlaneDeck(
        solution=ring, materials=Elastic(E=q.E, nu=q.nu), assumption="plane stress"
    )  # fmt: skip

    def read(solution: "PlaneSolution") -> dict[str, float]:
        mid, far = radial(solution, q.d_e / 2, np.array([0.0, q.half_angle]))
        return {"mid": float(mid), "corner": float(far)}

    return posed(deck, read(ring), seconds / 2, lambda fields: read(fields.solution))


K: dict[str, Any] = {"allowed": LINEAR, "why": MESH}
HUB: dict[str, Any] = {"unit": "µm", **K}
SIDES: tuple[tuple[str, Wall, Wall], ...] = (("outer", "bore", "rim"), ("inner", "rim", "bore"))
RINGS = (
    *(
        Cross(
            id=f"ring-lame, {a}", case="ring-lame", solver=CALCULIX,
            what=f"quarter of a ring under pressure in the bore and on the rim, {a}",
            pose=partial(lame, a),
            quantities=lame_quantities(a),
        )
        for a in ("plane stress", "plane strain")
    ),
    Cross(
        id="ring-rotation", case="ring-rotation", solver=CALCULIX,
        what="quarter of a rotating race, plane stress", pose=rotation,
        quantities=(
            Quantity(name="bore", row="bore growth, plane stress", symbol="δ_ce", unit="µm", **K),
            Quantity(name="rim", row="rim growth, plane stress", symbol="u_r", unit="µm", **K),
            Quantity(name="U", row="strain energy, plane stress", symbol="U", unit="J/m", **K),
            Quantity(name="hoop bore", row="bore hoop stress, plane stress", symbol="σ_θ",
                     unit="MPa", allowed=AVERAGED, why=NODAL),
        ),
    ),
    *(
        Cross(
            id=f"ring-loads-{side}", case=f"ring-loads-{side}", solver=CALCULIX,
            what="half a pitch of a race under a sprag, plane stress", pose=partial(sprags, loaded),
            quantities=sprags_quantities(loaded, far),
        )
        for side, loaded, far in SIDES
    ),
    Cross(
        id="polyhedral-ring", case="polyhedral-ring", solver=CALCULIX,
        what="half a sector of the ring under pressure, plane stress",
        pose=partial(polyhedral, "plane stress"),
        quantities=(
            Quantity(name="K_mid", row="K in the middle of the flats", symbol="K_mid", **K),
            Quantity(name="K_mean", row="K for the mean displacement of the outer surface",
                     symbol="K_mean", **K),
            Quantity(name="flexibility", row="reciprocal of K at the corners", symbol="1/K_corner",
                     **K),
            Quantity(name="fillet", row="largest hoop stress in the fillets", symbol="σ_max",
                     unit="MPa", allowed=AVERAGED,
                     why="the project computes the stresses from calculix's displacements"),
        ),
    ),
    Cross(
        id="polyhedral-ring, plane strain", case="polyhedral-ring", solver=CALCULIX,
        what="half a sector of the ring under pressure, plane strain",
        pose=partial(polyhedral, "plane strain"),
        quantities=(
            Quantity(name="K_mid", row="K in the middle of the flats, plane strain",
                     symbol="K_mid", **K),
        ),
    ),
    *(
        Cross(
            id=f"polyhedral-ring, hub at {place}", case="polyhedral-ring", solver=CALCULIX,
            what=f"half a sector of the ring under the force of the hub at {place}, plane stress",
            pose=partial(hub, corner),
            quantities=(
                Quantity(name="mid",
                         row="displacement of the outer surface at the middle of the flats under "
                         f"the hub force at {place}",
                         symbol="u_mid", **HUB),
                Quantity(name="corner",
                         row="displacement of the outer surface at the corners under the hub "
                         f"force at {place}",
                         symbol="u_corner", **HUB),
            ),
        )
        for place, corner in (("e", False), ("the corner", True))
    ),
)  # fmt: skip
