"""Error budgets of sprag clutches: races, wedge angle, length, time steps, plane assumption."""

from collections.abc import Mapping
from typing import Any

from verify.budget.statement import Cause, Rerun, Statement, Without

LIGHTER, THICKER, LONGER = 4, 3, 4


def light(q: Any) -> Any:
    """A quarter of the torque."""
    return q.model_copy(update={"T": q.T / LIGHTER})


def thick(q: Any) -> Any:
    """Races with thicker walls."""
    return q.model_copy(
        update={"R_id": q.R_i - 1.5 * (q.R_i - q.R_id), "R_ed": q.R_e + THICKER * (q.R_ed - q.R_e)}
    )


def long(q: Any) -> Any:
    """Longer sprags under the same load per length, their crown made for that."""
    more = {"l": LONGER * q.l, "T": LONGER * q.T}
    if q.Q is not None:
        more["Q"] = LONGER * q.Q
    return q.model_copy(update=more)


BOTH = Without(Cause.PLANE, "plane strain on both sides")
LONG = Rerun(cause=Cause.GEOMETRY, what="four times as long under the same load per length",
             inputs=long, levels=(41, 81))  # fmt: skip
STRIPS = (
    Without(Cause.CONTACT, "none: exact law, pressures are not negative"),
    Without(Cause.PLANE, "strips and slices, not plane"),
)
IN_TIME = (
    Without(Cause.CONTACT, "rigid sprags on springs by the formulas' own law"),
    Without(Cause.PLANE, "rigid bodies"),
    Without(Cause.GEOMETRY, "one model on both sides"),
)

STATEMENTS: Mapping[str, Statement] = {
    "sprag-wedge": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="a quarter of the torque: contacts half as wide",
                  inputs=light, levels=(9,)),
            Rerun(cause=Cause.GEOMETRY, what="races with thicker walls", inputs=thick, levels=(9,)),
        ),
        without=(BOTH,),
        headline="rotation of the sprags, at T",
    ),
    "sprag-engagement": Statement(without=IN_TIME),
    "sprag-friction": Statement(without=IN_TIME),
    "sprag-clutch": Statement(reruns=(LONG,), without=STRIPS, finer=321),
    "sprag-crown": Statement(reruns=(LONG,), without=STRIPS),
    "sprag-optimum": Statement(reruns=(LONG,), without=STRIPS, finer=321),
    "sprag-optimum-40": Statement(reruns=(LONG,), without=STRIPS, finer=321),
}  # fmt: skip
