"""Shafts and rotors of beam elements, compared with ROSS."""

import json
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.rotor.shaft.case import SHAFT
from verify.cases.rotor.sprag.case import SPRAG_ROTOR
from verify.cases.rotor.sprag.layout import CENTRAL, DISCS
from verify.cases.rotor.sprag.system_fem import rotor_fem
from verify.cases.rotor.step.case import STEP
from verify.cases.rotor.system.case import SYSTEM
from verify.cases.rotor.system.reference import fem_rotor
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.statement import ROSS, Cross, Posed, Quantity

if TYPE_CHECKING:
    from fem.rotor.model import Rotor

EXACT = 1e-6
BEAMS = "same beam elements and shear coefficients; only round-off of eigenvalues differs"
PIECES = 12  # elements of a shaft
HARD = 1e10  # N/m, of bearings that hold the ends of a shaft
MODES = 6


def shaft(turning: bool) -> Posed:
    """A uniform shaft in stiff bearings, with or without rotation."""
    from fem.rotor.model import Element, Material, Rotor, Shaft, Support

    q: Any = SHAFT.inputs()
    steel = Material(E=q.E, nu=q.nu, rho=q.rho)
    rotor = Rotor(
        [Shaft([Element(q.L / PIECES, q.d_o, q.d_i, steel)] * PIECES)],
        supports=[Support(0, HARD), Support(PIECES, HARD)],
    )  # fmt: skip
    return posed(rotor, [q.n if turning else 0.0])


def step(turning: bool) -> Posed:
    """A shaft with a step in diameter in elastic bearings, with or without rotation."""
    from verify.cases.rotor.step.reference import beam

    q: Any = STEP.inputs()
    return posed(beam(q, 4), [q.n if turning else 0.0])


def system(speeds: Sequence[float]) -> Posed:
    """Two coaxial shafts at the same speed, with discs and with bearings between the shafts."""
    q: Any = SYSTEM.inputs()
    alike = q.model_copy(update={
        "shafts": tuple(s.model_copy(update={"ratio": 1.0}) for s in q.shafts),
    })  # fmt: skip
    nodes = [u.node - 1 for u in q.unbalances]
    unbalance = {
        "nodes": nodes, "magnitudes": [u.value for u in q.unbalances],
        "phases": [u.angle for u in q.unbalances], "speeds": list(speeds), "probe": q.probe - 1,
    }  # fmt: skip
    return posed(fem_rotor(alike, 2), speeds, unbalance)


def sprags(node: int) -> Posed:
    """Both rotors of the paper, joined by bearings and clutch, under the unbalances of the rig.

    Bearings in ROSS act in x and y only. Therefore, both solvers omit the tilting and torsional
    stiffness of the clutch, the axial stiffness of bearings, and the drive.
    """
    from fem.rotor.model import Link, Support

    q: Any = SPRAG_ROTOR.inputs()
    whole = rotor_fem(CENTRAL, refine=2)
    across = replace(
        whole, supports=[Support(s.node, s.K[0, 0]) for s in whole.supports],
        links=[Link.bearing(one.a, one.b, one.stiffness[0, 0]) for one in whole.links],
    )  # fmt: skip
    unbalance = {
        "nodes": [n - 1 for n in DISCS], "magnitudes": [q.u_rig_1, q.u_rig_2], "phases": [0.0, 0.0],
        "speeds": [q.speed, q.rig_speed], "probe": node - 1,
    }  # fmt: skip
    return posed(across, [q.speed, q.rig_speed], unbalance)


def posed(
    rotor: "Rotor", speeds: Sequence[float], unbalance: dict[str, Any] | None = None
) -> Posed:
    """Problem of `rotor`: frequencies at each speed; with `unbalance`, also the probe's orbit."""
    from fem.rotor.modes import modes
    from fem.rotor.response import unbalance_response
    from verify.studies.crosscheck.rotors import asked, write

    def solve() -> dict[str, float]:
        found = {
            f"frequency {k}, speed {i}": float(w)
            for i, speed in enumerate(speeds, 1)
            for k, w in enumerate(modes(rotor, speed, MODES).frequencies, 1)
        }
        if unbalance:
            masses: dict[int, complex] = {}
            forces = zip(*(unbalance[k] for k in ("nodes", "magnitudes", "phases")), strict=True)
            for node, size, phase in forces:
                masses[node] = masses.get(node, 0.0) + size * np.exp(1j * phase)
            axes = unbalance_response(rotor, np.array(speeds), masses).major(unbalance["probe"])
            found |= {
                f"major semi-axis of the orbit, speed {i}": float(a) for i, a in enumerate(axes, 1)
            }
        return found

    ours, seconds = timed(solve)
    question = asked(rotor, speeds, MODES, unbalance)

    def read(deck: Path) -> dict[str, float]:
        there = json.loads(deck.with_suffix(".answer.json").read_text("utf-8"))
        found = {
            f"frequency {k}, speed {i}": w
            for i, row in enumerate(there["frequencies"], 1) for k, w in enumerate(row, 1)
        }  # fmt: skip
        return found | {
            f"major semi-axis of the orbit, speed {i}": a
            for i, a in enumerate(there.get("orbit", ()), 1)
        }

    return Posed(
        ours=ours, seconds=seconds, unknowns=len(rotor.M) * 4 // 6,
        write=lambda folder: write(question, folder / "deck.json"), read=read,
    )  # fmt: skip


def frequency(k: int, row: str = "", speed: int = 1, *, beside: bool = False) -> Quantity:
    return Quantity(name=f"frequency {k}, speed {speed}", row=row, symbol="ω", unit="rad/s",
                    allowed=EXACT, why=BEAMS, beside=beside)  # fmt: skip


SPEEDS = (200.0, 600.0, 1200.0)  # rad/s
ROTORS = (
    Cross(
        id="rotor-shaft", case="rotor-shaft", solver=ROSS,
        what=f"a uniform rotating shaft of {PIECES} elements in stiff bearings",
        pose=partial(shaft, True),
        quantities=(
            frequency(1, "elements of Timoshenko's beam: whirl frequency of mode 1 backward"),
            frequency(2, "elements of Timoshenko's beam: whirl frequency of mode 1 forward"),
            frequency(6, "elements of Timoshenko's beam: whirl frequency of mode 3 forward"),
        ),
    ),
    Cross(
        id="rotor-step", case="rotor-step", solver=ROSS,
        what="a rotating shaft with a thick part in elastic bearings", pose=partial(step, True),
        quantities=(
            frequency(1, "beam elements (Timoshenko): whirl frequency of mode 1 backward"),
            frequency(2, "beam elements (Timoshenko): whirl frequency of mode 1 forward"),
            frequency(6, "beam elements (Timoshenko): whirl frequency of mode 3 forward"),
        ),
    ),
    *(
        Cross(
            id=f"rotor-sprag, node {n}", case="rotor-sprag", solver=ROSS,
            what="two rotors connected by bearings and by a clutch that has radial stiffness only: "
            f"natural frequencies at 5,000 r/min (speed 1), and the orbit of node {n} at 7,000 "
            "r/min (speed 2)",
            pose=partial(sprags, n),
            quantities=(
                *(frequency(k, f"natural frequency {k}, beam elements", beside=True)
                  for k in whirls),
                Quantity(name="major semi-axis of the orbit, speed 2", symbol=f"x_{n}", unit="µm",
                         allowed=EXACT, why=BEAMS, beside=True,
                         row=f"amplitude of node {n} at the speed of the test rig, without "
                         "damping"),
            ),
        )
        for n, whirls in ((4, (1, 2, 3)), (19, (4, 5, 6)))
    ),
    Cross(
        id="rotor-system", case="rotor-system", solver=ROSS,
        what="two coaxial shafts at equal speeds (200, 600 and 1,200 rad/s) with discs, bearings "
        "to the ground and an intershaft bearing, all with damping",
        pose=partial(system, SPEEDS),
        quantities=(
            *(frequency(k, f"natural frequency {k} at speed n" if i == 2 else "", i,
                        beside=True)
              for i in (1, 2, 3) for k in (1, 2, 3, 4)),
            *(Quantity(name=f"major semi-axis of the orbit, speed {i}", symbol="|r|", unit="µm",
                       allowed=EXACT, why=BEAMS,
                       row="amplitude of the probe node" if i == 2 else "", beside=True)
              for i in (1, 2, 3)),
        ),
    ),
)  # fmt: skip
