"""The answer of `freewheel design` for a crown: pressure, margin, limiting criterion."""

from verify.answers.answer import Answer, Quantity
from verify.answers.assessment import Assessment
from verify.studies.design_sprag.console import named
from verify.studies.design_sprag.outcome import Outcome


def answer(outcome: Outcome) -> Answer:
    """Answer of a crown design; "holds" if the half-space checks agree and no limit is exceeded."""
    task = outcome.task
    k = int(outcome.pressures.argmax())
    what = f"largest pressure, {task.torques[k]:g} N m, with the crown {named(outcome.crown)}"
    peak = float(outcome.pressures[k])
    part = Assessment(
        design=Quantity(key="largest_pressure", symbol="p_max", value=peak, unit="MPa", what=what)
    )
    for T, p in zip(task.torques, outcome.pressures, strict=True):
        part.pressure(f"contact_pressure_{T:g}_N_m".replace(".", "_"), f"pressure at {T:g} N m",
                      float(p), task.clutch.E, given=task.wishes.p_lim,
                      option="give p_lim")  # fmt: skip
    if not outcome.verified:
        part.unknowns.append("the half-space does not confirm the pressures: see the table")
    return part.answer()
