"""Finite elements of the three line contacts: meshes, materials, supports."""

from typing import Any

from verify.cases.contact.line.reference import Pressed


def disc_fem(q: Any, P: float, guess: float, level: int) -> Pressed:
    """The quarter of the disc on the flat y = 0 under the load P [N/m]."""
    from fem.contact.pairs import Obstacle, Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle, Flat
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc

    def build(zone: float, cells: int, refine: int) -> ContactProblem:
        return ContactProblem(
            quarter_disc(R=q.R, zone=zone, cells=cells, refine=refine),
            materials=Elastic(E=q.E, nu=q.nu), assumption="plane strain",
            supports={"axis": "x", "middle": "y"}, obstacles={"flat": Obstacle(Flat())},
            contacts=[
                Pair(slave="surface", master="flat", slave_shape=Circle((0.0, q.R), q.R))
            ],
        )  # fmt: skip

    return Pressed(build, level, P=P, guess=guess, arc=q.R, softness=q.softness, cut="middle")


def pair_fem(q: Any, level: int) -> Pressed:
    """Quarters of both rollers under the load."""
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc
    from meshes.join import join

    def build(zone: float, cells: int, refine: int) -> ContactProblem:
        fine: dict[str, Any] = {"zone": zone, "cells": cells, "refine": refine}
        return ContactProblem(
            join({"upper": quarter_disc(R=q.R_1, **fine),
                  "lower": quarter_disc(R=q.R_2, below=True, **fine)}),
            materials={"upper": Elastic(E=q.E_1, nu=q.nu_1), "lower": Elastic(E=q.E_2, nu=q.nu_2)},
            assumption="plane strain",
            supports={"upper.axis": "x", "lower.axis": "x",
                      "upper.middle": "y", "lower.middle": "y"},
            contacts=[
                Pair(slave="upper.surface", master="lower.surface",
                     slave_shape=Circle((0.0, q.R_1), q.R_1),
                     master_shape=Circle((0.0, -q.R_2), q.R_2))
            ],
        )  # fmt: skip

    return Pressed(
        build, level, P=q.P, guess=q.guess, arc=q.R_1, softness=q.softness, cut="upper.middle"
    )


def race_fem(q: Any, level: int) -> Pressed:
    """A quarter of the roller in half a race whose rim is held, under the load."""
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc
    from meshes.contact.race import half_race
    from meshes.join import join

    def build(zone: float, cells: int, refine: int) -> ContactProblem:
        fine: dict[str, Any] = {"zone": zone, "cells": cells, "refine": refine}
        return ContactProblem(
            join({"roller": quarter_disc(R=q.R, **fine),
                  "race": half_race(r_i=q.r_i, r_o=q.r_o, **fine)}),
            materials={"roller": Elastic(E=q.E_1, nu=q.nu_1), "race": Elastic(E=q.E_2, nu=q.nu_2)},
            assumption="plane strain",
            supports={"roller.axis": "x", "race.axis": "x",
                      "roller.middle": "y", "race.rim": "xy"},
            contacts=[
                Pair(slave="roller.surface", master="race.bore",
                     slave_shape=Circle((0.0, q.R), q.R),
                     master_shape=Circle((0.0, q.r_i), q.r_i, hollow=True))
            ],
        )  # fmt: skip

    return Pressed(
        build, level, P=q.P, guess=q.guess, arc=q.R, softness=q.softness, cut="roller.middle"
    )
