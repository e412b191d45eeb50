"""Assumptions that formula and reference share: contacts and rotors."""

from collections.abc import Mapping
from typing import Any

from verify.answers.shared.record import Function, SharedReading, Values, only_at_paper, ratio

ENDS = SharedReading(
    assumption="the roller is uniform along the axis (plane strain)",
    part="its ends carry more or less than its middle", quantity="the largest pressure",
    source="not quantified here; see the cases contact-roller-flat and contact-roller-end",
)  # fmt: skip
SMOOTH = SharedReading(
    assumption="surfaces are smooth and free of friction",
    part="the surfaces are rough and have friction",
    quantity="the largest pressure",
)
RIM = SharedReading(
    assumption="the rim of the race is fixed over its whole circumference",
    part="the race is in an elastic housing",
    quantity="the approach δ",
)
PARALLEL = SharedReading(
    assumption="the axis of the roller is parallel to the race", part="the axis is tilted",
    quantity="the largest pressure outside the end zones d",
    source="not quantified here; -7 % at 0.03° (case contact-roller-tilted)",
)  # fmt: skip


def _half_space(effect: float) -> Function:
    """Function for the assumption that both bodies are half-spaces beyond the ends of the roller.

    `effect` is the relative error of the end load, computed by the case contact-roller-end.
    """

    def found(q: Any, _: Values) -> tuple[SharedReading, ...]:
        known = only_at_paper(q, effect)
        source = "case contact-roller-end, finite elements" if known else (
            "not quantified for these inputs; run case contact-roller-end")  # fmt: skip
        ends = SharedReading(
            assumption="both bodies are half-spaces, which extend beyond the ends",
            part="the roller ends there", quantity="the load in the end zones d",
            effect=known, source=source,
        )  # fmt: skip
        aligned = () if hasattr(q, "theta") else (PARALLEL,)
        return (ends, *aligned, SMOOTH)

    return found


CROWNED, FLAT = 0.289, 0.354  # end load of half-spaces over the end load of a roller with end faces


def _line(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (ENDS, SMOOTH)


def _ring(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (ENDS, RIM, SMOOTH)


def _slip(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the friction coefficient is the same for sticking and sliding",
            part="the two coefficients differ and change with "
                 "wear", quantity="the energy of a cycle W",
            source="not quantified; if the whole contact slips, W is proportional to μ",
        ),
        ENDS,
    )  # fmt: skip


def _sphere(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the bodies are spheres", quantity="the pressure p_0",
            part="sprag and race touch along a line",
        ),
        SMOOTH,
    )  # fmt: skip


def _press_fit(_: Any, v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the rings are free along the axis (rows in plane stress)",
            part="friction in the fit restrains rings of finite width "
                 "axially", quantity="the fit pressure p",
            source="plane strain, the other limit",
            effect=ratio(v, "p", "p_strain"),
        ),
        SharedReading(
            assumption="the pressure in the bore is "
                       "uniform", part="individual sprags press on the bore",
            quantity="the stresses in the inner ring",
            source="not quantified here; see case ring-loads-outer",
        ),
    )  # fmt: skip


def _end(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the edge of the end face is sharp", quantity="the load at the ends F_d",
            part="the edge has a chamfer or a radius",
        ),
        SMOOTH,
    )  # fmt: skip


def _links(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the races are rigid", part="the races bend under the sprags",
            quantity="the stiffness K_xx", source="not quantified; stiffnesses are too large",
        ),
        SharedReading(
            assumption="all sprags are identical", quantity="the stiffness K_xx",
            part="tolerances and wear load some sprags more than others",
        ),
    )  # fmt: skip


UNDAMPED = SharedReading(
    assumption="bearings and supports are linear springs on rigid ground",
    part="the stiffness of bearings depends on load and speed, and the casing deflects",
    quantity="the critical speeds",
)


def _shaft(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="bearings are rigid supports at the ends", part="the bearings deflect",
            quantity="the critical speed Ω_c", source="not quantified; Ω_c is too large",
        ),
    )  # fmt: skip


def _step(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the shaft is one body", quantity="the critical speed Ω_c",
            part="discs and sleeves that are shrunk on stiffen the shaft",
        ),
        UNDAMPED,
    )  # fmt: skip


def _system(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (
        UNDAMPED,
        SharedReading(
            assumption="discs are rigid", part="thin discs bend", quantity="the critical speeds"
        ),
    )


def _sprag_rotor(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (
        SharedReading(
            assumption="the identified parameters are the parameters of the test rig",
            part="12 unknowns are fitted to three printed speeds", quantity="all other speeds",
        ),
        UNDAMPED,
    )  # fmt: skip


CONTACTS: Mapping[str, Function] = {
    "contact-flat": _line,
    "contact-pair": _line,
    "contact-ring": _ring,
    "contact-slip": _slip,
    "contact-sphere": _sphere,
    "contact-press-fit": _press_fit,
    "contact-roller": _half_space(CROWNED),
    "contact-roller-tilted": _half_space(CROWNED),
    "contact-roller-flat": _half_space(FLAT),
    "contact-roller-crowns": _half_space(CROWNED),
    "contact-roller-end": _end,
    "rotor-clutch": _links,
    "rotor-shaft": _shaft,
    "rotor-step": _step,
    "rotor-system": _system,
    "rotor-sprag": _sprag_rotor,
}
