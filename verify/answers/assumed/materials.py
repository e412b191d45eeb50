"""Assumed material properties and friction that several cases share."""

from verify.answers.assumed.rules import Assumption, Given
from verify.answers.strengths import ROLLER_STATIC, SOURCES, contact_pressure

STEEL = (
    Assumption(name="E", value="206 GPa", usual=("200 GPa", "212 GPa"),
               source="typical: steel at room temperature, 200 to 212 GPa"),
    Assumption(name="nu", value=0.3, usual=(0.27, 0.3),
               source="typical: steel, 0.27 to 0.30"),
)  # fmt: skip
DENSITY = Assumption(name="density", value="7850 kg/m^3", source="typical: steel",
                     usual=("7700 kg/m^3", "7900 kg/m^3"))  # fmt: skip
ROLLER_FRICTION = Assumption(
    name="mu", value=0.08, usual=(0.06, 0.12),
    source="typical: hardened steel with oil, boundary lubrication, 0.06 to 0.12",
)  # fmt: skip


def static_pressure(g: Given) -> float | None:
    """Permissible static contact pressure [Pa] of steel parts by ISO 76; None for others."""
    moduli = [g.E, *(g[name] for name in ("E_r", "E_i", "E_o") if g.get(name) is not None)]
    return contact_pressure(None, *moduli).value


CONTACT_PRESSURE = Assumption(name="p_lim", value=static_pressure, source=SOURCES[ROLLER_STATIC],
                              varied=False)  # fmt: skip
