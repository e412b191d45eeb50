"""Error budgets of sprag clutches: races, wedge angle, length, time steps, plane assumption."""

from collections.abc import Mapping
from typing import Any

from verify.judging.budget_statement import Cause, Corrected, Left, Rerun, Statement, Without

LIGHTER, THICKER, LONGER, FLATTER = 4, 3, 4, 100


def light(q: Any) -> Any:
    """Inputs with a quarter of the torque."""
    return q.model_copy(update={"T": q.T / LIGHTER})


def thick(q: Any) -> Any:
    """Inputs with thicker walls of both races."""
    return q.model_copy(
        update={"R_id": q.R_i - 1.5 * (q.R_i - q.R_id), "R_ed": q.R_e + THICKER * (q.R_ed - q.R_e)}
    )


def long(q: Any) -> Any:
    """Inputs with sprags four times as long; T and Q are scaled in proportion to the length."""
    more = {"l": LONGER * q.l, "T": LONGER * q.T}
    if q.Q is not None:
        more["Q"] = LONGER * q.Q
    return q.model_copy(update=more)


def long_uncrowned(q: Any) -> Any:
    """Inputs of `long` with K_1 and z_m a hundredth as large: all slices carry equal loads."""
    more = long(q)
    return more.model_copy(update={"K_1": more.K_1 / FLATTER, "z_m": more.z_m / FLATTER})


def long_half_crowned(q: Any) -> Any:
    """Inputs of `long` with half the crown.

    With a smaller crown, the largest pressure would be at the ends.
    """
    more = long(q)
    return more.model_copy(update={"K_1": more.K_1 / 2, "z_m": more.z_m / 2})


BOTH = Without(Cause.PLANE, "both models are in plane strain")
LONG = Rerun(cause=Cause.GEOMETRY, what="sprags four times as long with the same load per length",
             inputs=long, levels=(41, 81))  # fmt: skip
# the deflection of a slice depends on its load only, a strip's deflection on all loads
EVEN = Rerun(
    cause=Cause.GEOMETRY, what="in addition, K_1 and z_m a hundredth as large, for a uniform load",
    rows=("pressure at mid-length*",), inputs=long_uncrowned, levels=LONG.levels, after=LONG.what,
)  # fmt: skip
# at the larger torque, the largest pressure would then be at the ends
HALF = Rerun(
    cause=Cause.GEOMETRY, what="in addition, K_1 and z_m half as large",
    rows=("largest pressure*",), inputs=long_half_crowned, levels=LONG.levels, after=LONG.what,
)  # fmt: skip
STRIPS = (
    Without(Cause.CONTACT, "none: both models satisfy the contact conditions exactly"),
    Without(Cause.PLANE, "strips and slices are not plane models"),
)
IN_TIME = (
    Without(Cause.CONTACT, "both models use the same deflection law"),
    Without(Cause.PLANE, "both models consist of rigid bodies"),
    Without(Cause.GEOMETRY, "both models have the same geometry"),
)

LAW = "slices use Palmgren's law of a whole roller; no computation by strips uses this law"
SLICED = (Left(("pressure at mid-length*", "largest pressure*"), LAW),)
WEDGE = Left(
    ("force ratio T_*tan*1.8 N_0", "excess of N_e*", "torque n_s N*1.8 N_0"),
    "a quarter of the torque and thicker races change the results by more than the difference "
    "between formula and reference",
)
STIFF = Left(("torsional stiffness of a clutch with rigid races*",), "the stiffness is T divided "
             "by the wind-up, whose difference is decomposed")  # fmt: skip
TURNED = Left(
    ("wind-up of the races by rolling*",),
    "neither a quarter of the torque nor thicker races explain the difference; no other cause was "
    "varied",
)

STATEMENTS: Mapping[str, Statement] = {
    "sprag-wedge": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY,
                  what="a quarter of the torque, so that the contacts are half as wide",
                  inputs=light, levels=(9,)),
            Rerun(cause=Cause.GEOMETRY, what="races with thicker walls", inputs=thick, levels=(9,)),
        ),
        without=(BOTH,), left=(WEDGE, TURNED, STIFF),
        corrected=(
            Corrected("rotation of the sprags with half planes and Eq. 6 for plane strain, at N_0",
                      "alpha_rigid",
                      "half planes and Eq. 6, against the deflections of elastic bodies"),
            Corrected("rotation of the sprags with Eqs. 9, 10 as printed and elastic deflections, "
                      "at N_0", "alpha_rigid"),
            Corrected("torque with the lever arm of Eq. 16 as printed, at N_0", "torque_rigid",
                      "lever arms are half of those of Eq. 9"),
            Corrected("rotation of the sprags with Palmgren's law, Eqs. 6 and 7, at N_0",
                      "alpha_rigid", "Palmgren's law, against deflections of elastic bodies"),
            Corrected("rotation of the sprags with Palmgren's law and Eq. 6, without Eq. 7, at N_0",
                      "alpha_rigid", "Palmgren's law, against deflections of elastic bodies"),
            Corrected("wind-up of a clutch with rigid races by Palmgren's law (Huang 2022, "
                      "Eqs. 2, 4), at N_0", "theta_rigid",
                      "rigid races and Palmgren's law, against elastic bodies"),
            Corrected("rotation of the sprags as in the paper, with Palmgren's law in Eqs. 9, 10 "
                      "as printed, at T", "alpha", "Palmgren's law and Eqs. 9, 10 as printed, "
                      "against corrected Eqs. 9, 10 with deflections of elastic bodies"),
            *(
                Corrected(row.format(race), f"{key}_{race[0].replace('o', 'e')}_rigid", what)
                for race in ("inner", "outer")
                for row, key, what in (
                    ("mean displacement of the {} race (Eq. 6 as printed, for plane stress), at "
                     "N_0",
                     "mean", "Eq. 6 as printed, for plane stress, against Eq. 6 for plane strain"),
                    ("displacement of the {} race under a sprag, taken as the mean displacement "
                     "by Eq. 6, at N_0", "race",
                     "mean displacement of the race, against that under a sprag"),
                )
            ),
        ),
        headline="rotation of the sprags, at T",
    ),
    "sprag-engagement": Statement(without=IN_TIME),
    "sprag-friction": Statement(without=IN_TIME),
    "sprag-clutch": Statement(reruns=(LONG,), left=SLICED, without=STRIPS, finer=321),
    "sprag-crown": Statement(reruns=(LONG,), left=SLICED, without=STRIPS),
    "sprag-optimum": Statement(reruns=(LONG, EVEN, HALF), left=SLICED, without=STRIPS, finer=321),
    "sprag-optimum-40": Statement(reruns=(LONG, EVEN), left=SLICED, without=STRIPS, finer=321),
}  # fmt: skip
