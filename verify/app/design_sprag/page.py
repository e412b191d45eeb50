"""The page of a crown design, in the units of the task."""

import time
from collections.abc import Sequence

from reports.design import DesignPage, Tile
from verify.app.design_sprag.figures import figures
from verify.cases.sprag.clutch.sketch import sketch
from verify.core.figures import Table
from verify.studies.design_sprag.console import (
    HEAD_CROWN,
    check_heads,
    check_line,
    crown_table,
    named,
    remarks,
    so_many,
    torque_heads,
    torque_table,
    torques,
    verdict,
    warnings,
)
from verify.studies.design_sprag.outcome import Outcome
from verify.studies.design_sprag.ranges import RANGES
from verify.studies.design_sprag.verified import Check

MPa, mm, um = 1e6, 1e-3, 1e-6
STEPS = (
    "A full factorial design of 5 × 5 × 5 crowns covers the ranges and their tolerances, with "
    "K_1 and z_m in "
    "equal ratios (the paper uses equal steps, Eq. 19). For each crown and torque, the "
    "equations of "
    "motion are integrated in time, and the largest normal force is used (Eqs. 11-17).",
    "The pressure is computed for the inner contacts, where it always exceeds the pressure of "
    "the outer contacts. "
    "The model consists of strips on a half-space, each a third of the contact's half-width "
    "wide. At a loaded end, "
    "the pressure is unbounded; therefore, the pressure of the end strip counts three times. "
    "Slices (Eqs. 2-5) "
    "represent the end of a sprag poorly: the optimal crown by slices is edge-loaded.",
    "A kriging model with a quadratic trend (Eq. 20) is fitted to the square of the pressure, "
    "separately "
    "for the end strip, the strips next to it and all other strips, because the maximum over "
    "all strips has kinks. New random "
    "crowns test the model. Where it is inaccurate, they are added to its sample, and new "
    "crowns are drawn.",
    "A search on the kriging model finds the optimal crown of each torque, then the target "
    "crown. The true model "
    "is evaluated at these crowns, which are added to the sample, until both models agree "
    "within 0.5 % twice in a row. With "
    "tolerances, every crown is replaced by the worst of its nominal shape and its limit "
    "shapes: drop larger or "
    "smaller over the whole length, crown longer or shorter.",
    "All printed values of a crown are those of the true model. A half-space model with "
    "rectangular cells verifies the crown "
    "under the same forces; in this model, the ends must be unloaded.",
)  # fmt: skip


def page(outcome: Outcome, command: str) -> DesignPage:
    """All content of the page."""
    task = outcome.task
    return DesignPage(
        name=task.name,
        subject="crown",
        of="a sprag's crown",
        front_name="Results by torque",
        meta=time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime())
        + " · after Huang, Zhao and Liu 2018, Eqs. 1-20",
        tiles=_tiles(outcome),
        failure=_failure(outcome),
        warnings=warnings(outcome),
        lead=_lead(outcome),
        sketch=sketch(task.clutch),
        chosen=_values(outcome),
        limits=Table(title="Numbers of the crown", header=("", *HEAD_CROWN),
                     rows=tuple(crown_table(outcome))),
        front=_torques(outcome),
        relaxations=(),
        checks=_checks(outcome),
        figures=figures(outcome),
        steps=STEPS,
        inputs=_inputs(outcome),
        command=command,
    )  # fmt: skip


def _tiles(outcome: Outcome) -> Sequence[Tile]:
    k = len(outcome.task.torques) - 1
    T = f"{outcome.task.torques[k]:g} N m"
    now, p = float(outcome.largest(outcome.now)[0, k]), float(outcome.pressures[k])
    worst = float(outcome.largest(outcome.chosen)[:, k].max())
    drawn = "" if outcome.search.single else f", within tolerance ({p / MPa:.0f} nominal)"
    shape = "" if outcome.search.single else "nominal, "
    less = f"{100 * (p / now - 1):+.1f} %".replace("-", "−")
    ends = f", edge-loaded: {so_many(outcome, k)}" if outcome.now_carries[k] else ""
    found = [
        Tile(number=f"{worst / MPa:.0f} MPa", words=f"largest at {T}{drawn}"),
        Tile(number=less, words=f"{shape}compared with the present crown{ends}"),
        Tile(
            number=f"{len(outcome.search.model.known)}", words="crowns with a simulated engagement"
        ),
    ]
    if outcome.checks:
        off = max(abs(c.off(c.judged)) for c in outcome.checks)
        ends = "; edge-loaded" if any(c.end > 0 for c in outcome.checks) else ""
        found.append(Tile(number=f"{100 * off:.1f} %", words="largest difference from a "
                                                             f"half-space{ends}",
                          css="is-pass" if outcome.verified else "is-fail"))  # fmt: skip
    return found


def _failure(outcome: Outcome) -> Sequence[str]:
    found = [] if outcome.verified else [verdict(outcome)]
    if outcome.exceeded:
        at = ", ".join(f"{T:g}" for T in outcome.exceeded)
        found.append(f"All crowns of these ranges exceed p_lim at {at} N m.")
    return found


def _lead(outcome: Outcome) -> str:
    aim = (
        "with the lowest maximum excess over the optimal crown of each torque"
        if outcome.relative
        else "with the lowest maximum pressure"
    )
    within = "" if outcome.search.single else ", within its tolerance,"
    return (
        f"{named(outcome.crown)} for Q = {outcome.search.model.Q:.5g} N. Of all crowns in the "
        f"ranges, it is the one {aim}{within} under {torques(outcome.task)}. "
        f"{sentence(verdict(outcome))}."
    )


def _values(outcome: Outcome) -> Sequence[tuple[str, str, str]]:
    q, (K_1, K_2, z_m) = outcome.task.clutch, outcome.crown
    N = outcome.chosen.N_max[0]
    return [
        ("K_1", "depth of the crown", f"{K_1:.4g}"),
        ("K_2", "crowned share of the length", f"{K_2:.4g}"),
        ("z_m", "drop at the ends", f"{z_m / um:.4g} µm"),
        ("Q", "reference load of K_1", f"{outcome.search.model.Q:.5g} N"),
        ("K_1 Q", "load for which the crown is designed", f"{K_1 * outcome.search.model.Q:.5g} N"),
        ("N_max", "largest force of a sprag", f"{N.max():.5g} N"),
        ("l", "length of the sprag", f"{q.l / mm:.5g} mm"),
        ("(1 − K_2) l", "straight length of the sprag", f"{(1 - K_2) * q.l / mm:.4g} mm"),
    ]


def _torques(outcome: Outcome) -> Table:
    names, more = torque_heads(outcome)
    heads = tuple(
        f"{name} [{unit}]" if unit in ("N m", "N") else f"{name} {unit}".strip()
        for name, unit in zip(names, more, strict=True)
    )
    more_remarks = " ".join(f"{sentence(line)}." for line in remarks(outcome))
    return Table(
        title="Results by torque", header=heads, rows=tuple(torque_table(outcome)),
        note=f"Largest pressures at the inner contacts during engagement, in MPa. {more_remarks}",
    )  # fmt: skip


def sentence(line: str) -> str:
    """The line with its first letter in upper case."""
    return f"{line[0].upper()}{line[1:]}"


def _checks(outcome: Outcome) -> Sequence[Table]:
    if not outcome.checks:
        return ()
    rows: Sequence[Check] = outcome.checks
    return (
        Table(
            title="The same forces on a half-space", header=check_heads(outcome),
            rows=tuple(check_line(c) for c in rows),
            note=f"Largest pressures in MPa. {verdict(outcome)}.",
        ),
    )  # fmt: skip


def _inputs(outcome: Outcome) -> Sequence[tuple[str, str, str]]:
    task = outcome.task
    found = [
        (v.symbol, v.what, v.value if isinstance(v.value, str)
         else f"{v.value:.6g}{'' if v.unit == '1' else f' {v.unit}'}")
        for v in task.wishes.display()
    ]  # fmt: skip
    found.append(("torques", "torques of engagement", torques(task)))
    for j, r in enumerate(RANGES):
        factor = um if j == 2 else 1.0
        unit = " µm" if j == 2 else ""
        ends = f"{task.low[j] / factor:.4g} to {task.high[j] / factor:.4g}{unit}"
        found.append((r.symbol, r.what, ends))
    return found
