"""Error budgets of roller freewheels: bodies of finite size, and the plane assumption."""

from collections.abc import Mapping
from typing import Any

from verify.judging.budget_statement import (
    Cause,
    Corrected,
    Left,
    Rerun,
    Statement,
    Without,
    plane_stress,
)

PROBLEM = "fem.contact.problem:ContactProblem"
LIGHTER, THICKER = 4, 4


def light(q: Any) -> Any:
    """Inputs with a quarter of the torque and of any axial load: contact widths are halved."""
    more = {"T": q.T / LIGHTER}
    if hasattr(q, "F_ax"):
        more["F_ax"] = q.F_ax / LIGHTER
    return q.model_copy(update=more)


def thick_ring(q: Any) -> Any:
    """Inputs of a star with a wall of the ring `THICKER` times as thick."""
    return q.model_copy(update={"R_a": q.R + THICKER * (q.R_a - q.R)})


def thick_cup(q: Any) -> Any:
    """Inputs of a cup with a wall twice as thick."""
    return q.model_copy(update={"R_a": q.X_o + 2 * (q.R_a - q.X_o)})


def rerun(**more: Any) -> Rerun:
    return Rerun(cause=Cause.GEOMETRY, **more)


LIGHT = rerun(what="a quarter of the load (contacts half as wide)", inputs=light, levels=(4,))
WALL = rerun(what="a ring with four times the wall thickness", inputs=thick_ring, levels=(4,))
PLANE = Rerun(cause=Cause.PLANE, what="plane stress instead of plane strain", shared=True,
              changes=plane_stress(PROBLEM), levels=(4,))  # fmt: skip
BOTH = Without(Cause.PLANE, "formula and reference are both in plane strain")
ALONG = Without(Cause.PLANE, "the model combines plane strain with axial displacement")

ROLLED = ("wind-up by exact rolling*",)
UNTURNED = (
    "a lower load and a thicker wall of the ring have no influence; no other cause was varied"
)
TURNED = Left(ROLLED, UNTURNED)
THIN = Left(
    (*ROLLED, "travel of the rollers*", "approach of roller and cup*",
     "normal force at a given wedge angle ψ", "largest torque*"),
    "only the load and the wall thickness of the cup were varied"
)  # fmt: skip

STAR = Left(("approach of roller and star*",), "the size of the star was not varied")  # fmt: skip

STATEMENTS: Mapping[str, Statement] = {
    "freewheel-torque": Statement(
        reruns=(LIGHT, WALL),
        without=(BOTH,),
        left=(TURNED, STAR),
        headline="normal force under torque (Eqs. 2, 3)",
        corrected=(
            Corrected(
                "clamping angle under torque, taken as α_0 (Eq. 4)",
                "alpha",
                "it is the clamping angle without load, but compared with the angle under torque",
            ),
            Corrected("clamping angle under torque, Eq. 4 as printed", "alpha"),
            Corrected("clamping angle under torque, Eq. 5 as printed", "alpha"),
            Corrected(
                "wind-up, Eq. 7 as printed, compared with the wind-up from the strain energy", "phi"
            ),
            Corrected(
                "torque z X F_t of the star, Eq. 3 as printed, at N = T/(z R tan α_0)",
                "torque_rigid",
            ),
        ),
    ),
    "freewheel-cup": Statement(
        reruns=(
            LIGHT,
            rerun(what="a cup with twice the wall thickness", inputs=thick_cup, levels=(4,)),
        ),
        without=(BOTH,),
        left=(THIN,),
        corrected=(
            Corrected(
                "clamping angle under torque, taken as α_0 (Eq. 4 for a cup)",
                "alpha",
                "it is the clamping angle without load, but compared with the angle under torque",
            ),
            Corrected(
                "wind-up, Eq. 7 as printed, with R_s and X_o, compared with the wind-up from the "
                "strain energy",
                "phi",
            ),
        ),
    ),
    "freewheel-friction": Statement(
        reruns=(LIGHT, WALL),
        without=(ALONG,),
        corrected=(
            Corrected("required friction, Eq. 8 as printed, with F_ax in place of F_a", "mu_req"),
            Corrected("tan α, Eq. 8 as printed", "mu_T"),
        ),
    ),
    "freewheel-paths": Statement(
        left=(Left(("axial load at slip*",), "no cause was varied for the load paths"),),
        without=(ALONG,),
    ),
    "freewheel-clutch": Statement(reruns=(LIGHT, WALL, PLANE), left=(TURNED,)),
}
