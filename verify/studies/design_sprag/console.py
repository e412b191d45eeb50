"""Output of `freewheel design` for a crown: the optimal crown, its pressures and checks."""

from collections.abc import Sequence

import numpy as np

from verify.core.console import aligned
from verify.core.figures import Array
from verify.core.terminal import print_wrapped
from verify.core.unit_systems import System, cells_in, text_in
from verify.studies.design_sprag.inputs import Task
from verify.studies.design_sprag.known import Known
from verify.studies.design_sprag.outcome import FLAT, SHALLOWER, Outcome
from verify.studies.design_sprag.search import AGREE
from verify.studies.design_sprag.verified import CELLS, LIMIT, Check

MPa, um = 1e6, 1e-6
SYMBOLS = ("K_1", "K_2", "z_m")
FORMS = ("{:.4g}", "{:.4g}", "{:.4g} µm")
UNITS = (1.0, 1.0, um)
ROUNDING = 1e-9  # tolerance for a crown on a bound


def print_outcome(outcome: Outcome, system: System = "mm") -> None:
    """Print the optimal crown, its pressure at each torque, its tolerance, half-space checks."""
    task = outcome.task
    print(f"{task.name}: {len(outcome.search.model.known):,} crowns engaged under {torques(task)}")
    best = f"optimal crown: {named(outcome.crown)}, for Q = {outcome.search.model.Q:.5g} N"
    print_wrapped(text_in(best, system))
    for line in aligned(cells_in([("", *HEAD_CROWN), *crown_table(outcome)], system)):
        print(f"  {line}")
    print("largest pressures during engagement [MPa]")
    for line in aligned([*torque_heads(outcome), *torque_table(outcome)]):
        print(f"  {line}")
    for line in remarks(outcome):
        print_wrapped(text_in(line, system))
    if outcome.checks:
        print("largest pressures by the half-space, under the same forces [MPa]")
        for line in aligned([check_heads(outcome), *map(check_line, outcome.checks)]):
            print(f"  {line}")
    print_wrapped(text_in(verdict(outcome), system))
    for warning in warnings(outcome):
        print_wrapped(text_in(f"warning: {warning}", system))


def named(crown: Array) -> str:
    """K_1, K_2 and z_m of a crown as text."""
    return ", ".join(
        f"{symbol} = {form.format(x / unit)}"
        for symbol, form, unit, x in zip(SYMBOLS, FORMS, UNITS, crown, strict=True)
    )


def torques(task: Task) -> str:
    """The torques of the task as text."""
    if len(task.torques) == 1:
        return f"{task.torques[0]:g} N m"
    return ", ".join(f"{T:g}" for T in task.torques[:-1]) + f" and {task.torques[-1]:g} N m"


HEAD_CROWN = ("present", "optimum", "range", f"within {100 * FLAT:g} %: alone", "combined")


def crown_table(outcome: Outcome) -> list[tuple[str, ...]]:
    """Cells, one line per crown parameter: present value, optimum, range, two equivalent ranges.

    The pressure is almost constant in the equivalent ranges: in the first if only this parameter
    is varied, in the second if all parameters are varied together.
    """
    task, q = outcome.task, outcome.task.clutch
    now = (q.K_1, q.K_2, q.z_m)
    return [
        (
            SYMBOLS[j],
            value_of(j, now[j]) if q.z_m else "none",
            value_of(j, outcome.crown[j]),
            span(j, np.array([task.low[j], task.high[j]])),
            span(j, outward(outcome.alone[j])),
            span(j, outward(outcome.together[j])),
        )
        for j in range(3)
    ]


def value_of(j: int, value: float) -> str:
    """Value of parameter number `j` as text with its unit."""
    return FORMS[j].format(value / UNITS[j])


def span(j: int, ends: Array) -> str:
    """Range of parameter number `j` as text: lower and upper end."""
    low, high = (f"{x / UNITS[j]:.3g}" for x in ends)
    return f"{low} to {high}" + (" µm" if j == 2 else "")


def outward(ends: Array) -> Array:
    """Two positive values rounded to three digits, the first down, the second up."""
    step = 10.0 ** (np.floor(np.log10(ends)) - 2)
    low, high = np.round(ends / step, 6)  # an error in the last digit is ignored
    return np.array([np.floor(low), np.ceil(high)]) * step


def torque_heads(outcome: Outcome) -> list[tuple[str, ...]]:
    """Two lines of column heads for the table of torques."""
    tolerance = not outcome.search.single
    return [
        ("T", "N_max", "N_max/Q", "present", "no crown", "optimum at T", "at", "", "", "chosen",
         *(("within its",) if tolerance else ()), "excess"),
        ("N m", "N", "", "", "", "in tolerance" if tolerance else "", "K_1", "K_2", "z_m", "",
         *(("tolerance",) if tolerance else ()), ""),
    ]  # fmt: skip


def torque_table(outcome: Outcome) -> list[tuple[str, ...]]:
    """Cells of the table of torques: largest pressures for different crowns, one line per torque.

    The crowns are the present crown, no crown, the optimal crown of the torque, and the chosen
    crown.
    """
    lines = []
    tolerance = not outcome.search.single
    for k, T in enumerate(outcome.task.torques):
        N = float(outcome.chosen.N_max[0, k])
        crown = outcome.best_crowns[k]
        lines.append((
            f"{T:g}", f"{N:.0f}", f"{N / outcome.search.model.Q:.3g}",
            pressure(outcome, outcome.now, k, ends=outcome.now_carries[k]),
            pressure(outcome, outcome.without, k, ends=True),
            f"{outcome.best[k] / MPa:.0f}", *(value_of(j, crown[j]) for j in range(3)),
            f"{outcome.pressures[k] / MPa:.0f}",
            *((band(outcome, k),) if tolerance else ()), percent(float(outcome.excess[k])),
        ))  # fmt: skip
    return lines


def percent(share: float) -> str:
    """A relative difference in per cent, as text; "< 0.01 %" if it is smaller."""
    return f"{100 * share:+.2g} %" if abs(share) >= 1e-4 else "< 0.01 %"


def band(outcome: Outcome, k: int) -> str:
    """Range of the largest pressure [MPa] over the crowns within the tolerance, as text."""
    p = outcome.largest(outcome.chosen)[:, k]
    return f"{p.min() / MPa:.0f} to {p.max() / MPa:.0f}"


def pressure(outcome: Outcome, known: Known, k: int, *, ends: bool) -> str:
    """Largest pressure [MPa] as text; for edge loading, with the number of slices or strips."""
    text = f"{outcome.largest(known)[0, k] / MPa:.0f}"
    return f"{text} (edge-loaded, {so_many(outcome, k)})" if ends else text


def so_many(outcome: Outcome, k: int) -> str:
    """Number of slices or strips under torque number `k`, as text."""
    contacts = outcome.task.wishes.contacts
    return f"{outcome.now.along(contacts, k).shape[1]} {contacts}"


def remarks(outcome: Outcome) -> list[str]:
    """Lines printed below the table of torques."""
    return [
        *compared(outcome), surely(outcome), *at_bounds(outcome), *on_edge(outcome),
        *by_slices(outcome),
    ]  # fmt: skip


def at_bounds(outcome: Outcome) -> list[str]:
    """Lines about bounds that the optimal crown reaches, if a wider range gives no advantage."""
    return [
        f"{SYMBOLS[b.parameter]} is at the end of its range; a wider range gives no advantage "
        f"({value_of(b.parameter, b.beyond)} was tried)"
        for b in outcome.bounds
        if not b.costs
    ]


def on_edge(outcome: Outcome) -> list[str]:
    """Recommendation to give tolerances if the optimal crown is close to edge loading."""
    if not (outcome.search.single and outcome.on_edge):
        return []
    return [f"give t_z, t_y: with z_m {100 * (1 - SHALLOWER):.0f} % less the crown is edge-loaded"]


def compared(outcome: Outcome) -> list[str]:
    """Line that states which pressures in the table can be compared; empty without tolerances."""
    if outcome.search.single:
        return []
    return [
        "present, no crown and chosen: nominal dimensions; optimum at T and excess: worst case "
        "within the tolerance; compare present with chosen, not with optimum at T"
    ]


def surely(outcome: Outcome) -> str:
    """Line with the errors of kriging at the optimal crown and at random crowns."""
    near, whole = outcome.search.judged[-1]
    return (
        f"kriging: error {percent(outcome.predicted / outcome.true - 1)} at the optimal crown "
        f"({100 * AGREE:g} % required), {outcome.rounds} rounds; on {near.count} new "
        f"random crowns near the optimum, mean error {100 * near.mean:.2f} %, "
        f"maximum {100 * near.largest:.2f} % (all {whole.count}: mean {100 * whole.mean:.2f} %, "
        f"maximum {100 * whole.largest:.2f} %)"
    )


def by_slices(outcome: Outcome) -> list[str]:
    """Line about the crown that is optimal in the model with slices, at the largest torque.

    The crown is selected from the evaluated crowns within the ranges. The list is empty if, by
    strips, the pressure of this crown is less than 0.5 % above that of the chosen crown, or if the
    task itself uses slices.
    """
    task, known = outcome.task, outcome.search.model.known
    if task.wishes.contacts == "slices":
        return []
    k = len(task.torques) - 1
    low, high = np.array(task.low) * (1 - ROUNDING), np.array(task.high) * (1 + ROUNDING)
    inside = np.all((known.crowns >= low) & (known.crowns <= high), axis=1)
    i = int(np.where(inside, known.slices[:, k].max(axis=1), np.inf).argmin())
    along = known.strips[k][i]
    of_slices, of_strips = known.slices[i, k].max(), along.max()
    T = task.torques[k]
    if of_strips < 1.005 * outcome.pressures[k]:
        return []
    at_ends = ", at its ends" if int(along.argmax()) in (0, len(along) - 1) else ""
    return [
        f"the slices of the paper give{' at the largest torque' if k else ''} the crown "
        f"{named(known.crowns[i])}: "
        f"{of_slices / MPa:.0f} MPa at {T:g} N m by {known.slices.shape[2]} slices, but "
        f"{of_strips / MPa:.0f} MPa by {known.strips[k].shape[1]} strips{at_ends}"
    ]


def check_heads(outcome: Outcome) -> tuple[str, ...]:
    """Column heads of the table of half-space checks."""
    n = outcome.task.clutch.slices
    cells = " by ".join(map(str, CELLS[1]))
    return ("T", "crown", f"{n} slices", f"{2 * n} slices", "strips", f"{cells} cells",
            "coarser cells", "strips error", "slices error", "at mid-length", "ends")  # fmt: skip


def check_line(c: Check) -> tuple[str, ...]:
    """Cells of one check. Differences are relative to the half-space."""
    return (
        f"{c.T:g} N m", c.which, f"{c.slices.max() / MPa:.1f}", f"{c.twice / MPa:.1f}",
        f"{c.strips.max() / MPa:.1f} ({len(c.strips)})", f"{c.peak / MPa:.1f}",
        f"{c.coarse / MPa:.1f}", f"{100 * c.off(float(c.strips.max())):+.2f} %",
        f"{100 * c.off(float(c.slices.max())):+.2f} %", f"{100 * c.mid_off:+.2f} %",
        "unloaded" if c.end == 0 else f"{c.end / MPa:.0f}",
    )  # fmt: skip


def verdict(outcome: Outcome) -> str:
    """PASS or FAIL of the contact model of the search, by comparison with the half-space."""
    contacts = outcome.task.wishes.contacts
    if not outcome.checks:
        return "not checked by a half-space"
    worst = max(outcome.checks, key=lambda c: abs(c.off(c.judged)))
    state = "PASS" if outcome.verified else "FAIL"
    loaded = ", ".join(f"{c.T:g} N m, {c.which}" for c in outcome.checks if c.end > 0)
    ends = f"; edge-loaded ({loaded}), where the pressure has no finite maximum" if loaded else ""
    return (
        f"{state} {contacts} within {100 * LIMIT:g} % of the half-space, ends unloaded: at most "
        f"{100 * worst.off(worst.judged):+.2g} %, {worst.T:g} N m, the {worst.which} crown{ends}"
    )


def warnings(outcome: Outcome) -> Sequence[str]:
    """Warnings for the chosen crown."""
    return [*_limits(outcome), *_ends(outcome), *_bounds(outcome), *_flat(outcome)]


def _limits(outcome: Outcome) -> list[str]:
    limit = outcome.task.wishes.p_lim
    if not outcome.exceeded or limit is None:
        return []
    at = ", ".join(f"{T:g}" for T in outcome.exceeded)
    return [f"p_lim = {limit / MPa:.5g} MPa is exceeded at {at} N m, also by the optimal crown"]


def _ends(outcome: Outcome) -> list[str]:
    loaded = [c for c in outcome.checks if c.end > 0 and c.which == "nominal"]
    if not loaded:
        return []
    at = ", ".join(f"{c.T:g}" for c in loaded)
    free = outcome.free_from
    mend = (
        f"z_m = {free / um:.3g} µm would unload them, with the same K_1 and K_2"
        if free
        else "increasing z_m alone does not unload them: increase K_1"
    )
    return [
        f"the ends are loaded at {at} N m: there the pressure has no finite maximum; slices and "
        f"strips are not valid; {mend}"
    ]


def _bounds(outcome: Outcome) -> list[str]:
    return [
        f"{SYMBOLS[b.parameter]} is at the end of its range: {value_of(b.parameter, b.beyond)} "
        f"would reduce the objective by {100 * b.gain:.2g} %"
        for b in outcome.bounds
        if b.costs
    ]


def _flat(outcome: Outcome) -> list[str]:
    """Warning if all crowns within the ranges are equivalent."""
    task = outcome.task
    if all(
        high - low >= 0.98 * (task.high[j] - task.low[j])
        for j, (low, high) in enumerate(outcome.alone)
    ):
        return [f"each parameter, over its range, changes the pressure by at most {100 * FLAT:g} %"
                ": all crowns of these ranges are equivalent"]  # fmt: skip
    return []
