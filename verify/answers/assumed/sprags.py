"""Assumed inputs of a sprag clutch: the proportions of the clutch in Huang 2018, Table 1.

The clutch of the paper has R_id = 7.21 mm, R_i = 11.11 mm, R_e = 19.44 mm, R_ed = 26.23 mm (gap
8.33 mm) and 12 sprags with r_i = 4.02 mm.
"""

import math

from verify.answers.assumed.materials import CONTACT_PRESSURE, DENSITY, STEEL
from verify.answers.assumed.rules import Assumption, Given

R_ID, R_I, R_E, R_ED = 7.21e-3, 11.11e-3, 19.44e-3, 26.23e-3  # m, Huang 2018, Table 1
CURVATURE, SPRAG_LENGTH = 4.02e-3, 9e-3  # m
GAP = R_E - R_I
INERTIA = 1.41e-3  # kg m^2, of either race
PITCH_OVER_GAP = 0.96  # of 12 sprags on the mean radius of the paper's clutch
WIDTH_OVER_GAP = 0.48
RECTANGLE = 0.7625  # width of the rectangle of mass m_g and inertia I_g, over b
FEWEST, MOST = 3, 200


def gap(g: Given) -> float:
    """Radial gap R_e - R_i [m] between the races. Raises ValueError unless R_e > R_i > 0."""
    if not g.R_e > g.R_i > 0:
        raise ValueError(
            f"R_e > R_i > 0 is required, got R_e = {g.R_e * 1e3:g} mm, R_i = {g.R_i * 1e3:g} mm"
        )
    return float(g.R_e - g.R_i)


def number(g: Given) -> int:
    """Number of sprags on the mean circle of the gap, with the pitch-to-gap ratio of the paper."""
    z: int = math.floor(math.pi * (g.R_i + g.R_e) / (PITCH_OVER_GAP * gap(g)))
    return min(max(z, FEWEST), MOST)


def mass(g: Given) -> float:
    """Mass [kg] of a sprag, represented by a rectangle with the height of the gap."""
    return float(g.density * g.l * RECTANGLE * g.b * gap(g))


def inertia(g: Given) -> float:
    """Moment of inertia [kg m^2] of the rectangle that represents a sprag, about its centre."""
    return float(mass(g) * ((RECTANGLE * g.b) ** 2 + gap(g) ** 2) / 12)


def race_inertia(g: Given) -> float:
    """Moment of inertia [kg m^2] of a race: the paper's value, scaled in proportion to R_i^4 l."""
    return float(INERTIA * (g.R_i / R_I) ** 4 * g.l / SPRAG_LENGTH)


SCALED = "the paper's inertia times (R_i/11.11 mm)^4 l/(9 mm), Huang 2018, Table 1"
OF_SPRAG = "of a rectangle of height R_e - R_i and width 0.76 b, which has m_g and I_g of "\
    "Huang 2018, Table 1"  # fmt: skip

SEED = Assumption(name="seed", value=0, source="numerical: seed of the random numbers",
                  varied=False)  # fmt: skip

SPRAG_CLUTCH = (
    Assumption(name="R_id", value=lambda g: R_ID / R_I * g.R_i,
               source="0.649 R_i, the proportion of Huang 2018, Table 1"),
    Assumption(name="R_ed", value=lambda g: R_ED / R_E * g.R_e,
               source="1.349 R_e, the proportion of Huang 2018, Table 1"),
    Assumption(name="r_i", value=lambda g: CURVATURE / GAP * gap(g),
               source="0.483 (R_e - R_i), the proportion of Huang 2018, Table 1"),
    Assumption(name="nu_0", value="3.15 deg", usual=("2.5 deg", "4 deg"),
               source="typical: 2.5 to 4 deg; 3.15 deg follows from the printed pressures of "
               "Huang 2018"),
    Assumption(name="z", value=number,
               source="mean circumference 2π (R_i + R_e)/2 divided by the spacing 0.96 (R_e - "
                      "R_i) of Huang 2018, "
               "Table 1"),
    Assumption(name="b", value=lambda g: WIDTH_OVER_GAP * gap(g),
               source="typical: 0.48 (R_e - R_i)"),
    *STEEL,
    DENSITY,
    CONTACT_PRESSURE,
    Assumption(name="z_m", value="10 µm",
               source="Huang 2018, Fig. 12: drop of the crown at the ends; without a crown, the "
                      "pressure "
               "of a sprag is largest at its ends"),
    Assumption(name="K_1", value=1.0, source="Huang 2018, Fig. 12: the best of the printed crowns"),
    Assumption(name="K_2", value=0.7, source="Huang 2018, Fig. 12: the best of the printed crowns"),
    Assumption(name="Q", value=lambda g: g.T / (g.z * g.R_i * math.tan(g.nu_0)),
               source="the normal force of a sprag under T, without deflections"),
    Assumption(name="mu_s", value=0.12, usual=(0.1, 0.15),
               source="typical: hardened steel with oil at rest, 0.10 to 0.15"),
    Assumption(name="mu_c", value=lambda g: min(0.08, g.mu_s),
               source="typical: hardened steel with oil, sliding, at most the static value",
               dynamic=True),
    Assumption(name="gamma_b", value="1 s/m", dynamic=True,
               source="typical: friction decreases over a sliding speed of about 1 m/s"),
    Assumption(name="slices", value=41,
               source="numerical: the number of slices of this suite's cases"),
    Assumption(name="alpha_max", value=lambda g: min(g.b / (2 * g.r_i), 3.0),
               source="b/(2 r_i), half of the angle that a sprag of width b subtends"),
    Assumption(name="m_g", value=mass, source=OF_SPRAG, dynamic=True),
    Assumption(name="I_g", value=inertia, source=OF_SPRAG, dynamic=True),
    Assumption(name="I_bi", value=race_inertia, source=SCALED, dynamic=True),
    Assumption(name="I_be", value=race_inertia, source=SCALED, dynamic=True),
    Assumption(name="K_r", value="0.01 N m/rad", source="Huang 2018, Table 1"),
    Assumption(name="C_rl", value="0.1 N m s/rad", source="Huang 2018, Table 1", dynamic=True),
    Assumption(name="k_out", value="1e5 N m/rad", dynamic=True,
               source="typical: stiff support; Huang 2018 gives no value, only that it is large"),
    Assumption(name="dt", value="1e-5 s", source="numerical: time step of Huang 2018, Sec. 4",
               dynamic=True),
    Assumption(name="t_end", value="0.06 s", dynamic=True,
               source="numerical: the simulated time of this suite's cases"),
)  # fmt: skip
