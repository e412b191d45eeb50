"""The accordion spring as a strip of plane cells, at small and at large displacement."""

from collections.abc import Callable, Mapping
from functools import partial
from math import sqrt
from typing import TYPE_CHECKING, Any

import numpy as np

from fem.beam.released import linear_load
from fem.unit_load import stiffness
from verify.cases.spring.accordion.case import ACCORDION
from verify.cases.spring.accordion.ends import Ends
from verify.cases.spring.accordion.reference import curved_frame, line_of
from verify.cases.spring.buckling.case import BUCKLING
from verify.cases.spring.buckling.reference import spring
from verify.cases.spring.continuum.case import CONTINUUM
from verify.cases.spring.continuum.reference import cells_along
from verify.cases.spring.curve.case import CURVE
from verify.cases.spring.curve.fem import Spring, fem_compress
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.comparisons import plane
from verify.studies.crosscheck.comparisons.plane import LINEAR, MESH
from verify.studies.crosscheck.statement import CALCULIX, Cross, Numbers, Posed, Quantity

if TYPE_CHECKING:
    from verify.studies.crosscheck.calculix.large import Answer
    from verify.studies.crosscheck.calculix.strips import Strip

FINE = 3.5  # cells over the root of length over thickness
THIN = 0.1  # of the thickness, how wide a strip of plane stress is
LEVEL = 8  # elements of an arc here, and cells there
STRIP = (
    "the project has beams, calculix has plane elements; for arcs of thickness b and radius R, "
    "the stiffnesses by both differ by the fraction (b/R)²/30"
)
SLENDER: Any = {"allowed": 1e-3, "why": STRIP}
TWO_SIDES = (
    "the tolerance of u_y is larger than that of u_x, because u_y is a small sum of displacements "
    "of opposite sign"
)
STEEP = "near P, u_y changes by 6.4 % if the stiffness changes by 1 %"
UNITS = 6  # of a spring whose tips are to touch
PRESSED = (6e-3, 9e-3)  # m, its compression: the tips are separated, and touch
APART, TOUCHING = "force before the tips touch", "force after the tips touch"
ASIDE = 1e-6  # m, that a head is moved aside
# N, unit of force for a thin strip: calculix regards smaller residuals as zero
# below a millionth of the unit, which is 0.7 % of a newton's load on so thin a strip
SMALL = 1e-3


def continuum(assumption: Any) -> Posed:
    """The spring as a plane body under a force of 1 N, on the same cells."""
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.spring.strip import strip
    from verify.studies.crosscheck.calculix.plane import PlaneDeck

    q: Any = CONTINUUM.inputs()
    along = cells_along(q, 2)
    mesh = strip(**q.path, b=q.b, through=2, per_arc=along["arc"], per_leaf=along["leaf"])
    tail = mesh.p[:, np.unique(mesh.facets[:, mesh.boundaries["tail"]])].mean(axis=1)
    x = float(tail[0])
    steel = Elastic(E=q.E, nu=q.nu)

    def parabola(centre: float, force: float) -> Any:
        def traction(at: Any) -> Any:
            shape = 1.5 * (1 - (2 * (at[0] - centre) / q.b) ** 2)
            return np.array([force / (q.b * q.h) * shape, np.zeros_like(shape)])

        return traction

    body, seconds = timed(lambda: solve_plane(
        mesh, materials=steel, assumption=assumption, supports={"tail": "y"},
        anchors={(x, float(tail[1])): "x"}, thickness=q.h,
        tractions={"head": parabola(0.0, 1.0), "tail": parabola(x, -1.0)},
    ))  # fmt: skip
    deck = PlaneDeck(solution=body, materials=steel, assumption=assumption)
    return plane.posed(
        deck, {"k": 1 / (2 * body.strain_energy)}, seconds,
        lambda fields: {"k": 1 / (2 * fields.energy)},
    )  # fmt: skip


def accordion(tail: Any, head: Any) -> Posed:
    """The frame of curved elements under 1 N, compared with plane elements along the same line."""
    given: Any = ACCORDION.inputs()
    q = given.held(Ends("", "", head, tail))
    solved, seconds = timed(lambda: curved_frame(q, line_of(q, 2 * LEVEL)))

    def problem(part: "Strip") -> dict[str, Any]:
        from verify.studies.crosscheck.calculix.large import Held, Load
        from verify.studies.crosscheck.calculix.strips import section_held

        guided = [Held(part.across[0], 1)] if head == "guided" else []
        return {
            "held": [*section_held(part, -1, 1), *guided], "linear": True,
            "steps": [[Load(part.middle(0), 0, 1 / q.h)]], "watched": [part.middle(0)],
        }  # fmt: skip

    return posed(
        q, q.path | {"tail": tail}, problem, {"k": stiffness(solved)[0]}, seconds,
        lambda answer: {"k": 1 / float(answer.u[0, 0, 0])},
    )  # fmt: skip


def aside() -> Posed:
    """Lateral stiffness of the guided head without axial load."""
    q: Any = BUCKLING.inputs()
    path = q.path | {"tail": "arc"}
    one = spring(q, path, q.b, LEVEL)
    (k, _), seconds = timed(lambda: one.lateral_stiffness(one.guided.rest()))

    def problem(part: "Strip") -> dict[str, Any]:
        from verify.studies.crosscheck.calculix.large import Held
        from verify.studies.crosscheck.calculix.strips import section_held

        return {
            "held": [*section_held(part, -1, 1), Held([part.middle(0)], 0)], "linear": True,
            "steps": [[Held(part.across[0], 1, ASIDE)]], "watched": [part.middle(0)],
        }  # fmt: skip

    return posed(
        q, path, problem, {"k_y": k}, seconds,
        lambda answer: {"k_y": float(answer.reaction[0, 1]) * q.h / ASIDE},
    )  # fmt: skip


def buckled(tail: str) -> Posed:
    """Linear buckling load of the spring with a free head."""
    q: Any = BUCKLING.inputs()
    path = q.path | {"tail": tail}
    one = spring(q, path, q.b, LEVEL)
    (load, _), seconds = timed(lambda: linear_load(one))

    def problem(part: "Strip") -> dict[str, Any]:
        from verify.studies.crosscheck.calculix.large import Load
        from verify.studies.crosscheck.calculix.strips import section_held

        return {
            "held": section_held(part, -1, 1), "linear": True, "buckling": True,
            "steps": [[Load(part.middle(0), 0, 1 / q.h)]], "watched": [part.middle(0)],
        }  # fmt: skip

    return posed(q, path, problem, {"F": load}, seconds, None)


def drift(share: float) -> Posed:
    """Spring with a free head at large displacement, under a force of constant direction."""
    q: Any = BUCKLING.inputs()
    path = q.path | {"tail": "arc"}
    one = spring(q, path, q.b, LEVEL)

    def solve() -> Any:
        steps = np.linspace(0.05, share, 20)
        return one.frame("").under_loads({one.head: (q.P, 0.0, 0.0)}, steps)

    loaded, seconds = timed(solve)
    u = loaded.u[-1, one.head, :2]

    def problem(part: "Strip") -> dict[str, Any]:
        from verify.studies.crosscheck.calculix.large import Load
        from verify.studies.crosscheck.calculix.strips import section_held

        return {
            "held": section_held(part, -1, 1), "watched": [part.middle(0)], "increment": 0.25,
            "steps": [[Load(part.middle(0), 0, share * q.P / q.h / SMALL)]],
        }  # fmt: skip

    return posed(
        q, path, problem, {"u_x": float(u[0]), "u_y": float(u[1])}, seconds,
        lambda answer: dict(zip(("u_x", "u_y"), answer.u[-1, 0].tolist(), strict=True)), SMALL,
    )  # fmt: skip


def curve() -> Posed:
    """A guided spring of six units, compressed until its tips touch its leaves."""
    q: Any = CURVE.inputs()
    line = dict(q.path) | {"n": UNITS}
    wide = 1 / (1 - q.nu**2)
    own = Spring(line=line, b=q.b, h=1.0, E=q.E, nu=q.nu, factor=wide, head="guided",
                 tail="mid-leaf")  # fmt: skip
    found, seconds = timed(lambda: fem_compress(own, PRESSED, per_arc=LEVEL))
    if not found.press[0].sum() == 0 < found.press[-1].sum():
        raise ArithmeticError(
            "the tips must be separated at the first step and must touch at the last step"
        )
    ours = dict(zip((APART, TOUCHING), found.F.tolist(), strict=True))

    from fem.plane.material import Elastic
    from verify.studies.crosscheck.calculix.compressed import compressed
    from verify.studies.crosscheck.calculix.large import answer, write_deck

    problem = compressed(line, q.b, PRESSED, material=Elastic(E=q.E, nu=q.nu))
    return Posed(
        ours=ours, seconds=seconds, unknowns=2 * len(problem.points),
        write=lambda folder: write_deck(problem, folder / "deck.inp"),
        read=lambda deck: dict(
            zip((APART, TOUCHING), answer(problem, deck).reaction[:, 0].tolist(), strict=True)
        ),
    )  # fmt: skip


def posed(
    q: Any, path: Mapping[str, Any], problem: "Callable[[Strip], dict[str, Any]]", ours: Numbers,
    seconds: float, read: "Callable[[Answer], Numbers] | None", unit: float = 1.0,
) -> Posed:  # fmt: skip
    """Problem of a strip along the line `path` in plane stress.

    Without `read`, the buckling factor is read from the results. `unit` [N] is the unit of force in
    the deck, also of the loads in `problem`.
    """
    from fem.plane.material import Elastic
    from meshes.spring import path as line
    from verify.studies.crosscheck.calculix.large import Problem, answer, factor, write_deck
    from verify.studies.crosscheck.calculix.strips import strip

    pieces = list(line.accordion(**path))
    # quadratic cells of length l bend a piece of length L with an error of (l/L)^2 (l/b)^2
    counts = [max(4, round(FINE * sqrt(piece.length / q.b))) for piece in pieces]
    part = strip(pieces, counts, q.b)
    own: Problem = Problem(
        points=part.points, cells=part.cells, material=Elastic(E=q.E / unit, nu=q.nu),
        assumption="plane stress", width=THIN * q.b, **problem(part),
    )  # fmt: skip
    return Posed(
        ours=ours, seconds=seconds, unknowns=2 * len(part.points),
        write=lambda folder: write_deck(own, folder / "deck.inp"),
        read=lambda deck: (
            {name: factor(deck) for name in ours} if read is None else read(answer(own, deck))
        ),
    )  # fmt: skip


SPRINGS = (
    *(
        Cross(
            id=f"spring-continuum, {a}", case="spring-continuum", solver=CALCULIX,
            what=f"the spring as a plane body under 1 N, {a}", pose=partial(continuum, a),
            quantities=(
                Quantity(name="k", row=f"stiffness, thick curved frame, {a}", symbol="k",
                         unit="N/mm", allowed=LINEAR, why=MESH),
            ),
        )
        for a in ("plane stress", "plane strain")
    ),
    *(
        Cross(
            id=f"spring-accordion, {head}, {tail}", case="spring-accordion", solver=CALCULIX,
            what=f"the spring under 1 N, head {head}, tail clamped at {tail}",
            pose=partial(accordion, tail, head),
            quantities=(
                Quantity(name="k", symbol="k", unit="N/mm", **SLENDER,
                         row=f"stiffness, head {head}, tail clamped at {tail}: curved elements"),
            ),
        )
        for head in ("free", "guided") for tail in ("arc", "mid-leaf")
    ),
    Cross(
        id="spring-buckling, aside", case="spring-buckling", solver=CALCULIX,
        what="the guided head of the spring, displaced laterally", pose=aside,
        quantities=(
            Quantity(name="k_y", symbol="k_y", unit="N/mm", **SLENDER, row="lateral stiffness of "
                     "the guided head, unloaded, tail clamped at its arc"),
        ),
    ),
    *(
        Cross(
            id=f"spring-buckling, linear, {tail}", case="spring-buckling", solver=CALCULIX,
            what=f"linear buckling load of the spring, head free, tail clamped at {words}",
            pose=partial(buckled, tail),
            quantities=(
                Quantity(name="F", symbol="F_lin", unit="N", **SLENDER, row="linear buckling load "
                         f"of the undeformed spring, tail clamped at {words}"),
            ),
        )
        for tail, words in (("arc", "its arc"), ("mid-leaf", "mid-leaf"))
    ),
    *(
        Cross(
            id=f"spring-buckling, drift{near}", case="spring-buckling", solver=CALCULIX,
            what=f"free head of the spring under a dead load of {share:g} times the Euler load P, "
            "large displacement",
            pose=partial(drift, share),
            quantities=(
                Quantity(name="u_x", symbol="u_x", unit="mm", **SLENDER),
                Quantity(name="u_y", symbol="u_y", unit="mm", allowed=5e-3, why=why,
                         row=f"lateral displacement of a free head under {share:g} times the "
                         "Euler load P, tail clamped at its arc"),
            ),
        )
        for share, near, why in ((0.5, "", TWO_SIDES), (0.9, " near P", f"{TWO_SIDES}; {STEEP}"))
    ),
    Cross(
        id="spring-curve", case="spring-curve", solver=CALCULIX,
        what="a spring of six segments, compressed until its tips touch, plane strain", pose=curve,
        quantities=(
            Quantity(name=APART, symbol="F", unit="N/mm", allowed=5e-3, why=STRIP,
                     beside=True, row="initial stiffness of the unloaded spring"),
            Quantity(name=TOUCHING, symbol="F", unit="N/mm", allowed=5e-3,
                     why="calculix enforces the contact of the tips by a penalty",
                     beside=True, row="no interpenetration of leaves"),
        ),
    ),
)  # fmt: skip
