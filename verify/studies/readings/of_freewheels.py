"""Readings for roller freewheels and the polyhedral ring: Nagler et al., Belcin et al.

These papers contain few numbers. Therefore, the readings of a printed equation are compared with
a result derived from the geometry or from an equilibrium, for the example in the ledger.
"""

import math
from collections.abc import Mapping
from typing import Any

from verify.studies.readings.problem import Problem
from verify.studies.readings.readings import count, doubled, result, switched
from verify.studies.readings.search import Reading

# mm and N: the example of the ledger, 2 α_0 = 7°
EXAMPLE = {"R": 16.5, "r": 2.5, "X": 11.39565, "F_n": 1.0}
LAST_OF_X = {"X": 5e-6}  # computed from the angle
# N, mm: the design of the ledger's entries on Eqs. 13 and 21
POLYGON = {"z": 6, "d_i": 72.0, "d_e": 80.0, "b": 30.0, "D_i": 100.06, "j_D": 0.06, "e": 9.0,
           "E": 210e3, "p_t": 30.0, "mu": 0.08, "tan_phi": 0.05}  # fmt: skip


def half_angle(q: Mapping[str, Any]) -> float:
    """Angle α_0 of Eq. 4 [deg] with the numerator that `q` selects."""
    x = (q[q["numerator"]] + q["X"]) / (2 * (q["R"] - q["r"]))
    root = math.sqrt(x) if q["root"] else x
    return float(math.degrees(q["inverse"](root)) * q["share"])


def _half_angle_readings() -> tuple[Reading, ...]:
    return (
        switched("numerator", "R instead of r in the numerator", numerator="R"),
        switched("root", "without the root", root=False),
        switched("inverse", "sin instead of cos", inverse=math.asin),
        switched("inverse", "tan instead of cos", inverse=math.atan),
        switched("share", "2 α instead of α", share=2.0),
        switched("share", "α instead of 2 α", share=0.5),
        doubled("R"),
        doubled("r"),
        doubled("X"),
    )


def loaded_angle(q: Mapping[str, Any]) -> float:
    """Angle α_1 of Eq. 5 [deg] without load.

    `q["above"]` and `q["below"]` are the signs of r in the numerator and in the denominator.
    """
    x = (q["X"] + q["above"] * q["r"]) / (q["ring"] + q["below"] * q["r"])
    return float(0.5 * math.degrees(math.acos(x)) * q["share"])


def _loaded_angle_readings() -> tuple[Reading, ...]:
    return (
        switched("below", "minus sign of r in the denominator", below=-1.0),
        switched("above", "minus sign of r in the numerator", above=-1.0),
        switched("ring", "outer radius of the ring, 22 mm", ring=22.0),
        switched("share", "2 α instead of α", share=2.0),
        switched("share", "α instead of 2 α", share=0.5),
        doubled("r"),
        doubled("X"),
        doubled("ring", "R"),
    )


def torque_of_one(q: Mapping[str, Any]) -> float:
    """Torque of one roller [N mm] by Eq. 3, with F_t = F_n tan α."""
    alpha = math.acos((q["X"] + q["r"]) / (q["R"] - q["r"])) / 2 * q["times"]
    return float(q[q["lever"]] * q["F_n"] * q["of"](alpha))


def _torque_readings() -> tuple[Reading, ...]:
    return (
        switched("lever", "R instead of X", lever="R"),
        switched("lever", "r instead of X", lever="r"),
        switched("of", "sin α instead of tan α", of=math.sin),
        switched("times", "2 α instead of α", times=2.0),
        *result()[:2],
    )


def side_force(q: Mapping[str, Any]) -> float:
    """Force [N] on one side of the polygon under a pressure of 1 MPa, by Eq. 13."""
    half = math.pi / q["z"]
    width = q["b"] * q["d_i"]
    return float(width * (math.sin(half) if q["chord"] else half) * q["across"])


def _side_readings() -> tuple[Reading, ...]:
    return (
        switched("chord", "chord instead of arc", chord=True),
        Reading(name="d_i across the flats", of="d_i", inputs=lambda q: {
            "d_i": q["d_i"] * math.cos(math.pi / q["z"])}),
        doubled("d_i"),
        *count("z"),
        *result()[:2],
    )  # fmt: skip


def first_torque(q: Mapping[str, Any]) -> float:
    """Torque of one roller [N m] by Eq. 21.

    Eq. 21 as printed contains the factor 360°/β once too often on its left side.
    """
    delta, d_m = (q["d_e"] - q["d_i"]) / 2, (q["d_e"] + q["d_i"]) / 2
    p_2 = q["p_t"] - 2 * delta * q["E"] * q["j_D"] / (q["d_i"] * d_m)
    psi = math.atan(q["e"] / (q["d_i"] / 2 * math.cos(math.pi / q["z"])))
    held = 2 / (q["mu"] * q["D_i"])
    held -= 2 / (q["d_i"] * math.tan(psi + math.atan(q["tan_phi"])))
    around = q["z"] * math.sin(math.pi / q["z"]) if q["chord"] else math.pi
    return float(around * q["d_i"] * q["b"] * p_2 / held / q["z"] / 1e3)


def _first_torque_readings() -> tuple[Reading, ...]:
    return (
        switched("chord", "perimeter of the polygon instead of the circumference", chord=True),
        *count("z"),
        doubled("d_i"),
        doubled("D_i"),
        doubled("j_D"),
        *result()[:2],
    )


PROBLEMS = (
    Problem(
        reference="nagler2021:eq-4-numerator", case="freewheel-torque",
        what="clamping angle without load by Eq. 4 as printed",
        formula=half_angle, readings=_half_angle_readings, derived="3.5000", unit="deg",
        inputs=lambda: EXAMPLE | {
            "numerator": "r", "root": True, "inverse": math.acos, "share": 1.0},
        rounding=LAST_OF_X, errata=("eq-4-numerator",),
    ),
    Problem(
        reference="nagler2021:eq-5-denominator-signs", case="freewheel-torque",
        what="clamping angle without load by Eq. 5 as printed", formula=loaded_angle,
        derived="3.5000", unit="deg",
        inputs=lambda: {"X": 11.39565, "r": 2.5, "ring": 16.5, "above": 1.0, "below": 1.0,
                        "share": 1.0},
        readings=_loaded_angle_readings, rounding=LAST_OF_X, errata=("eq-5-denominator-signs",),
    ),
    Problem(
        reference="nagler2021:eq-3-lever-on-the-flat", case="freewheel-torque",
        what="torque of one roller on the star by Eq. 3 as printed", formula=torque_of_one,
        derived="1.00916",
        inputs=lambda: EXAMPLE | {"lever": "X", "of": math.tan, "times": 1.0}, unit="N mm",
        readings=_torque_readings, rounding=LAST_OF_X, errata=("eq-3-lever-on-the-flat",),
    ),
    Problem(
        reference="belcin:eq-13-side-force", case="polyhedral-locking",
        what="force on one side of a hexagon under 1 MPa by Eq. 13 as printed", formula=side_force,
        derived="1080.0",
        inputs=lambda: POLYGON | {"chord": False, "across": 1.0}, unit="N",
        readings=_side_readings, errata=("eq-13-side-force",),
    ),
    Problem(
        reference="belcin:eq-21-factor", case="polyhedral-clutch",
        what="torque of one roller by Eq. 21 as printed",
        formula=first_torque, inputs=lambda: POLYGON | {"chord": False}, derived="443.9",
        unit="N m", readings=_first_torque_readings,
        errata=("eq-21-factor", "eqs-17-20-side-force"),
    ),
)  # fmt: skip
