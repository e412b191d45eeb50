"""Assumptions that formula and reference share: races and polyhedral rings."""

import math
from collections.abc import Mapping
from typing import Any

from verify.answers.shared.record import Function, SharedReading, Values, equal_shares, ratio

FREE = "the ring is free along its axis (plane stress)"
HELD = "a ring that is held along its axis is in plane strain"
WIDE = "if held along its axis, it is in plane strain; if wide with free ends, it lies between both"
STRAIN = "plane strain, ends held"
LIMIT = "plane strain, the other limit"


def narrow_race(r_i: float, r_o: float, nu: float, *, bore: bool) -> float:
    """Ratio of the displacement of a loaded wall in plane stress to that in plane strain, minus 1.

    The pressure acts on the bore if `bore` is True, otherwise on the rim. Both displacements are
    by Lamé's formulas.
    """
    loaded, other = (r_i, r_o) if bore else (r_o, r_i)
    stress = (1 - nu) * loaded**2 + (1 + nu) * other**2
    strain = (1 + nu) * ((1 - 2 * nu) * loaded**2 + other**2)
    return stress / strain - 1


def _lame(_: Any, v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the pressure is uniform around the race",
            part="individual sprags or rollers press on the "
                 "race", quantity="the displacement under a sprag",
            source="not quantified here; -25 % for 12 sprags (case ring-loads-outer)",
        ),
        SharedReading(
            assumption="the race is free along the axis (rows in plane stress)",
            part=HELD, quantity="the bore displacement", source=STRAIN,
            effect=ratio(v, "u_bore", "u_bore_strain"),
        ),
    )  # fmt: skip


def _loads(q: Any, _: Values) -> tuple[SharedReading, ...]:
    bore = q.loaded == "bore"
    radial = SharedReading(
        assumption="the sprags press along radii, without friction",
        part="friction at a sprag adds a tangential force of some percent of the radial force",
        quantity="the displacement under a sprag",
    )
    width = SharedReading(
        assumption=FREE, part=HELD, quantity="the mean displacement",
        effect=narrow_race(q.r_i, q.r_o, q.nu, bore=bore), source=STRAIN,
    )  # fmt: skip
    outer = SharedReading(
        assumption=f"the sprag has the radius {q.R * 1e3:.4g} mm at both races",
        part="the radius at the outer race is not printed; a logarithmic sprag has 4.34 mm in "
             "case sprag-wedge",
        quantity="the Hertz pressure p_0", source="with 4.34 mm",
        effect=((1 / q.R - 1 / q.r_i) / (1 / SPRAG_END - 1 / q.r_i)) ** 0.5 - 1,
    )  # fmt: skip
    return (width, *((outer,) if bore and math.isclose(q.R, SPRAG_PRINTED) else ()), radial,
            equal_shares("sprags", "the displacement under a sprag"))  # fmt: skip


SPRAG_PRINTED, SPRAG_END = 4.02e-3, 4.3376e-3  # m, inner radius as printed, outer of sprag-wedge


def _map(q: Any, _: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption=FREE, part=HELD, source=f"{STRAIN}, r_o/r_i = 1.35, mean of the bore",
            quantity="displacements", effect=narrow_race(1.0, 1.35, q.nu, bore=True),
        ),
        equal_shares("sprags", "displacements"),
    )  # fmt: skip


def _rotation(_: Any, v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the race is free along the axis (rows in plane stress)",
            part=HELD, quantity="the bore growth", source=STRAIN,
            effect=ratio(v, "growth", "growth_strain"),
        ),
        SharedReading(
            assumption="only the race rotates, without sprags", quantity="the bore growth",
            part="the sprags on its bore add a centrifugal force",
        ),
    )  # fmt: skip


def _round(_: Any, v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the bore is round", quantity="the pressure p_1",
            part="the bore has flats", source="not quantified here; -9 % for six flats "
            "(K_mid of case polyhedral-ring)",
        ),
        SharedReading(
            assumption=FREE, part=HELD, quantity="the pressure p_1", source=STRAIN,
            effect=ratio(v, "p", "p_strain"),
        ),
    )  # fmt: skip


def _polygon(_: Any, v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption=FREE, part=WIDE, quantity="the pressure factor K_mid", source=LIMIT,
            effect=ratio(v, "K_mid", "K_mid_strain"),
        ),
    )  # fmt: skip


def _flats(q: Any, _: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption=FREE, part=WIDE, quantity="the pressure factor K_mid", source=LIMIT,
            effect=-(q.nu**2),
        ),
    )  # fmt: skip


RIGID_RACE = SharedReading(
    assumption="the race outside the rollers is rigid",
    part="the race deflects under the rollers",
    quantity="the roller force N",
    source="not quantified; N is too large",
)


def _locking(q: Any, _: Values) -> tuple[SharedReading, ...]:
    return (
        RIGID_RACE,
        SharedReading(
            assumption=FREE, part=WIDE, source=LIMIT, effect=-(q.nu**2),
            quantity="the pressure p_1r at which the ring reaches the rollers",
        ),
        SharedReading(
            assumption="the rollers are free of friction", part="friction acts on them",
            quantity="the roller force N",
        ),
    )  # fmt: skip


def _wedge(q: Any, _: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="ring and race are equal flats about the roller",
            part="the race is a concave cylinder of the diameter D_i", source="Hertz",
            quantity="the pressure p_0 on the race", effect=(1 - q.d / q.D_i) ** -0.5 - 1,
        ),
        SharedReading(
            assumption="ring and race are equal flats about the roller",
            part="the ring is convex, of the radius D_i/2 - d", source="Hertz",
            quantity="the pressure p_0 on the ring",
            effect=(1 + q.d / (q.D_i - 2 * q.d)) ** -0.5 - 1,
        ),
        equal_shares("rollers", "the torque M_t"),
    )  # fmt: skip


def _clutch(_: Any, v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="ring and rollers are free along the axis (plane stress)",
            part=WIDE.replace("it is", "they are").replace("it lies", "they lie"),
            quantity="the torque M_el", source=LIMIT, effect=ratio(v, "M_el", "M_wide"),
        ),
        RIGID_RACE,
        equal_shares("rollers", "the torque M_el"),
    )  # fmt: skip


RINGS: Mapping[str, Function] = {
    "ring-lame": _lame,
    "ring-loads-outer": _loads,
    "ring-loads-inner": _loads,
    "ring-loads-map": _map,
    "ring-rotation": _rotation,
    "polyhedral-pressure": _round,
    "polyhedral-ring": _polygon,
    "polyhedral-map": _flats,
    "polyhedral-locking": _locking,
    "polyhedral-wedge": _wedge,
    "polyhedral-clutch": _clutch,
}
