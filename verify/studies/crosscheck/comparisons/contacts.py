"""Rollers, spheres, press fits and slipping discs in contact, compared with calculix."""

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.contact.line.flat import FLAT
from verify.cases.contact.line.pair import PAIR
from verify.cases.contact.line.reference import disc_fem, pair_fem
from verify.cases.contact.press_fit.case import PressFit
from verify.cases.contact.press_fit.inputs import FITS, Fit
from verify.cases.contact.press_fit.reference import read, solve_fit
from verify.cases.contact.slip.case import SlippingRollers
from verify.cases.contact.slip.reference import ZONE
from verify.cases.contact.sphere.case import Spheres
from verify.cases.contact.sphere.inputs import WORDS, Pair
from verify.cases.contact.sphere.reference import problem
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.comparisons.touching import (
    CONTACT,
    PENALTY,
    Touched,
    along_first_moment,
    posed,
)
from verify.studies.crosscheck.statement import CALCULIX, Cross, Numbers, Posed, Quantity

if TYPE_CHECKING:
    from fem.contact.pressed_line import PressedLine

STIFF, SOFTER = 500.0, 100.0  # slopes of the penalty [E/a], without friction and with it
LEVEL = 3
LOAD = "load at the approach of the project's solution"
NORMAL, PUSH = "normal force", "tangential force at the project's displacement"
SLIPPING = 6  # cells on the half-width of slipping discs


def line(case: Any, solve: Any) -> Posed:
    """Quarters of rollers, displaced at their cut until the contact carries the load."""
    from fem.plane.material import Elastic
    from verify.studies.crosscheck.calculix.contact import ContactDeck, Settings

    q: Any = case.inputs()
    found: PressedLine
    found, _ = timed(lambda: solve(q))
    state, seconds = timed(
        lambda: found.problem.solve(displacements={found.cut: {"y": -found.approach}})
    )
    steel: Any = (
        Elastic(E=q.E, nu=q.nu) if case is FLAT
        else {"upper": Elastic(E=q.E_1, nu=q.nu_1), "lower": Elastic(E=q.E_2, nu=q.nu_2)}
    )  # fmt: skip
    E = steel.E if case is FLAT else max(m.E for m in steel.values())
    deck = ContactDeck(
        states=[state], materials=steel, assumption="plane strain",
        how=Settings(slope=STIFF * E / found.a),
    )  # fmt: skip
    ours = {
        LOAD: 2 * abs(state.touches[0].force[1]), "a": along_first_moment(state.touches[0]),
        "p_0": found.peak,
    }  # fmt: skip

    def there(fields: Touched) -> Numbers:
        force, moment = abs(fields.force()[1]), abs(fields.moment())
        return {LOAD: 2 * force, "a": 3 * np.pi / 4 * moment / force, "p_0": fields.peak()}

    return posed(deck, ours, seconds, there)


def sphere(pair: Pair) -> Posed:
    """An axisymmetric sphere, displaced by the mutual approach that Hertz's theory gives."""
    from fem.contact.point_contact import push
    from fem.plane.material import Elastic
    from verify.studies.crosscheck.calculix.contact import ContactDeck, Settings

    q = Spheres().of(pair)
    spheres, a = problem(q, LEVEL), q.width
    hertz = a**2 / q.hertz["R"]
    state, seconds = timed(lambda: spheres.solve(displacements={"upper.middle": {"y": -hertz}}))
    materials = {"upper": Elastic(E=q.E_1, nu=q.nu_1)}
    if pair == "sphere":
        materials["lower"] = Elastic(E=q.E_2, nu=q.nu_2)
    deck = ContactDeck(
        states=[state], materials=materials, assumption="axisymmetric",
        how=Settings(slope=STIFF * q.E_1 / a),
    )  # fmt: skip
    return posed(
        deck, {"load": push(state)}, seconds, lambda fields: {"load": -fields.force()[1]}
    )  # fmt: skip


def fit(which: Fit) -> Posed:
    """Quarters of two rings with an interference fit."""
    from fem.plane.material import Elastic
    from verify.studies.crosscheck.calculix.contact import ContactDeck, Settings

    q = PressFit().of(which)
    state, seconds = timed(lambda: solve_fit(q, 2))
    deck = ContactDeck(
        states=[state], assumption=which.ends, how=Settings(slope=100 * q.E_i / q.delta),
        materials={"inner": Elastic(E=q.E_i, nu=q.nu_i), "outer": Elastic(E=q.E_o, nu=q.nu_o)},
    )  # fmt: skip
    own = read(q, state)
    ours = {"p": own["p"], "u, inner bore": own["u_inner_bore"],
            "u, outer rim": own["u_outer_rim"]}  # fmt: skip

    def there(fields: Touched) -> Numbers:
        from verify.studies.crosscheck.comparisons.plane import outwards

        walls = {"inner bore": "inner.bore", "outer rim": "outer.rim"}
        # the share that presses along x does not depend on the pressure
        found = {"p": own["p"] * fields.force()[0] / state.touches[0].force[0]}
        return found | {f"u, {k}": outwards(fields.solution, v) for k, v in walls.items()}

    return posed(deck, ours, seconds, there)


def slip(stage: float) -> Posed:
    """Pressed half discs; the tangential load rises to Q_max, then becomes `stage` * Q_max."""
    from fem.contact.driven_discs import DrivenDiscs
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.disc import half_disc
    from meshes.join import join
    from verify.studies.crosscheck.calculix.contact import ContactDeck, Settings

    q = SlippingRollers()
    fine: Any = {"R": q.R, "zone": ZONE * q.a, "cells": SLIPPING, "refine": 1}
    steel = Elastic(E=q.E, nu=q.nu)
    problem = ContactProblem(
        join({"upper": half_disc(**fine), "lower": half_disc(**fine, below=True)}),
        materials=steel, assumption="plane strain",
        supports={"lower.middle": "xy", "upper.middle": "xy"},
        contacts=[Pair(
            slave="upper.surface", master="lower.surface", friction=q.mu,
            slave_shape=Circle((0.0, q.R), q.R), master_shape=Circle((0.0, -q.R), q.R),
        )],
    )  # fmt: skip
    rollers = DrivenDiscs(problem, P=q.P, approach=q.width**2 / q.R)
    Q_max = q.share * q.mu * q.P
    pressed, cut = rollers.pressed
    pushed, top = rollers.loaded(Q_max, cut, pressed)
    states = [pressed, pushed]
    if stage < 1:
        states.append(rollers.loaded(stage * Q_max, top * (stage, 1.0), pushed)[0])
    _, seconds = timed(lambda: rollers.at(top, pressed))
    deck = ContactDeck(
        states=states, materials=steel, assumption="plane strain",
        how=Settings(slope=SOFTER * q.E / q.a, increments=2, cut=True),
    )  # fmt: skip
    x, y = states[-1].touches[0].force
    return posed(
        deck, {NORMAL: -y, PUSH: x}, len(states) * seconds,
        lambda fields: {NORMAL: -fields.force()[1], PUSH: fields.force()[0]},
    )  # fmt: skip


def line_quantities(approach: str) -> tuple[Quantity, ...]:
    return (
        Quantity(name=LOAD, row=f"{approach}, Hertz", beside=True, symbol="P(δ)", unit="N/mm",
                 allowed=CONTACT, why=PENALTY),
        Quantity(name="a", row="half-width, Hertz", symbol="a", unit="µm", allowed=CONTACT,
                 why=PENALTY),
        Quantity(name="p_0", row="peak pressure, Hertz", symbol="p_0", unit="MPa",
                 allowed=CONTACT, why=PENALTY),
    )  # fmt: skip


CONTACTS = (
    Cross(
        id="contact-flat", case="contact-flat", solver=CALCULIX,
        what="a quarter of a roller on a rigid flat, plane strain",
        pose=partial(line, FLAT, lambda q: disc_fem(q, q.P, q.guess, LEVEL)),
        quantities=line_quantities("approach of flat and roller centre"),
    ),
    Cross(
        id="contact-pair", case="contact-pair", solver=CALCULIX,
        what="quarters of two rollers, plane strain",
        pose=partial(line, PAIR, lambda q: pair_fem(q, LEVEL)),
        quantities=line_quantities("approach of the centres"),
    ),
    *(
        Cross(
            id=f"contact-sphere, {pair}", case="contact-sphere", solver=CALCULIX,
            what=f"an axisymmetric sphere at Hertz's approach, {words}",
            pose=partial(sphere, pair),
            quantities=(
                Quantity(name="load", row=f"force at Hertz's approach, {words}", symbol="P(δ)",
                         unit="N", allowed=CONTACT, why=PENALTY),
            ),
        )
        for pair, words in WORDS.items()
    ),
    *(
        Cross(
            id=f"contact-slip, {words}", case="contact-slip", solver=CALCULIX,
            what=f"half discs with friction, pressed by P, upper half disc {words} (pushed: "
                 "Q = Q_max; swung back: Q = −Q_max/2), plane strain",
            pose=partial(slip, stage),
            quantities=(
                Quantity(name=NORMAL, symbol="P", unit="N/mm", allowed=CONTACT, why=PENALTY),
                Quantity(name=PUSH, row=row, beside=True, symbol="Q(δ)", unit="N/mm",
                         allowed=CONTACT,
                         why="in calculix, nodes in the stick zone slip by a small amount"),
            ),
        )
        for stage, words, row in (
            (1.0, "pushed", "displacement minus the chord of the force-displacement curve, "
             "Q/(μP) = 0.6"),
            (-0.5, "swung back", "cycle: L2 error of the traction below 3 %, Q/Q_max = -0.5"),
        )
    ),
    *(
        Cross(
            id=f"contact-press-fit, {one.name}", case="contact-press-fit", solver=CALCULIX,
            what=f"quarters of two rings pressed into each other, {one.ends}",
            pose=partial(fit, one),
            quantities=(
                Quantity(name="p", row=f"mean contact pressure, {one.words}", symbol="p",
                         unit="MPa", allowed=CONTACT, why=PENALTY),
                Quantity(name="u, inner bore", symbol="u_r(r_i)", unit="µm", allowed=CONTACT,
                         row=f"displacement of the inner wall's bore, {one.words}",
                         why=PENALTY),
                Quantity(name="u, outer rim", symbol="u_r(r_o)", unit="µm", allowed=CONTACT,
                         row=f"displacement of the outer wall's rim, {one.words}",
                         why=PENALTY),
            ),
        )
        for one in FITS if one.key == "drawn"
    ),
)  # fmt: skip
