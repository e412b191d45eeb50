"""Error budgets of rotors: slenderness, steps, wedge angle, crown and offset."""

import math
from collections.abc import Mapping
from typing import Any

from verify.judging.budget_statement import Cause, Left, Rerun, Statement, Without

SLENDER, SMALLER = 4, 10


def slender(q: Any) -> Any:
    """Inputs of a shaft four times as long; the speed is scaled."""
    return q.model_copy(update={"L": SLENDER * q.L, "n": q.n / SLENDER**2})


def slender_step(q: Any) -> Any:
    """Inputs of a stepped shaft four times as long, with unchanged seats; k and n are scaled."""
    return q.model_copy(update={
        "L": SLENDER * q.L, "L_2": SLENDER * q.L_2, "k": q.k / SLENDER**3, "n": q.n / SLENDER**2,
    })  # fmt: skip


def low_step(q: Any) -> Any:
    """Inputs of a shaft whose step is a tenth as high."""
    return q.model_copy(update={"d_2": q.d_1 + (q.d_2 - q.d_1) / SMALLER})


def low_and_slender(q: Any) -> Any:
    """Inputs of a slender shaft with a low step: both causes of the error of a beam are reduced."""
    return slender_step(low_step(q))


def flat(q: Any) -> Any:
    """Inputs with a quarter of the wedge angle and unchanged normal forces."""
    nu = q.nu / 4
    return q.model_copy(update={"nu": nu, "T": q.T * math.tan(nu) / math.tan(q.nu)})


def centred(q: Any) -> Any:
    """Inputs with a tenth of the offset."""
    return q.model_copy(update={"e": q.e / SMALLER})


def uncrowned(q: Any) -> Any:
    """Inputs with a tenth of the crown's drop."""
    return q.model_copy(update={"drop": q.drop / SMALLER})


LOW = "a step a tenth as high"
BEAM = (
    "frequency of Timoshenko*", "frequency of Euler*", "frequency of Rayleigh*", "beam with*",
    "beam by*",
)  # fmt: skip
SOLID = (
    Without(Cause.PLANE, "both models are bodies of revolution"),
    Without(Cause.CONTACT, "the models contain no contact"),
)

STATEMENTS: Mapping[str, Statement] = {
    "rotor-clutch": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY,
                  what="a quarter of the wedge angle, with the same normal forces",
                  inputs=flat, rows=("stiffness*", "tilting*", "coupling*", "torsional*")),
            Rerun(cause=Cause.DISPLACEMENT, what="a tenth of the offset", inputs=centred,
                  rows=("*offset*", "*and tilt")),
            Rerun(cause=Cause.GEOMETRY, what="a tenth of the drop of the crown", inputs=uncrowned,
                  rows=("*crown*",)),
        ),
        left=(
            Left(("tilting stiffness*", "coupling*offset and tilt"),
                 "neither wedge angle nor offset nor crown explains this difference; no other "
                 "cause was varied"),
            Left(("stiffness along x, sprags pinned*",),
                 "with a smaller wedge angle the difference changes its sign: two effects of "
                 "opposite sign partly cancel each other"),
        ),
        without=(Without(Cause.PLANE, "the sprags are struts, not plane bodies"),
                 Without(Cause.CONTACT, "both models use the same contact law")),
        finer=256,
    ),
    "rotor-shaft": Statement(
        reruns=(Rerun(cause=Cause.GEOMETRY, what="a shaft four times as long", rows=BEAM,
                      inputs=slender, levels=(4, 8)),),
        without=SOLID, finer=12,
    ),
    "rotor-step": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what=LOW, rows=BEAM, inputs=low_step),
            # a longer shaft also has a relatively lower step: the cause would count twice
            Rerun(cause=Cause.GEOMETRY,
                  what="a step a tenth as high on a shaft four times as long", rows=BEAM,
                  inputs=low_and_slender, after=LOW),
        ),
        without=SOLID, finer=4,
    ),
    "rotor-system": Statement(finer=16),
    "rotor-sprag": Statement(finer=16),
}  # fmt: skip
