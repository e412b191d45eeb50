"""Finite elements of a thick ring: plane stress, plane strain, straight cell edges."""

from typing import Any

import numpy as np

from verify.case import Level, plane_field
from verify.cases.ring import walls


def solve(q: Any, level: int) -> Level:
    """Results of a quarter of the ring on the mesh of `level`, by all three models."""
    values: dict[str, float] = {}
    arrays: dict[str, Any] = {}
    loads: dict[str, Any] = {"pressures": {"bore": q.p_i, "rim": q.p_o}, "degree": 2}
    thin, long = (
        walls.quarter_fem(q, q.r_i, q.r_o, ends, level, **loads)
        for ends in ("plane stress", "plane strain")
    )
    straight = walls.quarter_fem(q, q.r_i, q.r_o, "plane strain", level, straight=True, **loads)
    values["U_straight"] = 4 * straight.strain_energy
    for ring, state in ((thin, ""), (long, "_strain")):
        read = _read(ring) | {"balance": ring.reaction("x=0")[0] + q.p_i * q.r_i - q.p_o * q.r_o}
        values |= {f"{name}{state}": value for name, value in read.items()}
    values["axial"] = values.pop("axial_strain")
    for ring, edges in ((long, ""), (straight, "_straight")):
        body = ring.in_body()
        arrays |= {f"x{edges}": body.x, f"u{edges}": body.u, f"weight{edges}": body.weight}
    profiles = dict(walls.across(q, long))
    # without prescribed displacement, energy and potential differ by round-off; the residual is
    # the residual of displacements, not of energies
    round_off = max(
        max(abs(ring.potential_energy / ring.strain_energy + 1), ring.residual**0.5)
        for ring in (thin, long, straight)
    )
    u_it = {key: round_off * abs(value) for key, value in values.items()}
    u_it |= {key: round_off * float(np.abs(array).max()) for key, array in profiles.items()}
    cells = ("stress", "von_mises", "hoop_stress")
    fields = (
        plane_field(thin, *cells, name="plane stress"),
        plane_field(long, *cells, name="plane strain"),
    )
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays | profiles, fields=fields)


def _read(ring: Any) -> dict[str, float]:
    """Mean displacements and stresses of a quarter, and four times its energy, by quantity."""
    bore, rim, middle = (ring.on_boundary(name) for name in ("bore", "rim", "middle"))
    body = ring.in_body()
    return {
        "U": 4 * ring.strain_energy,
        "u_bore": bore.mean(bore.polar()[0]),
        "u_rim": rim.mean(rim.polar()[0]),
        "hoop_bore": bore.mean(bore.polar()[2]),
        "hoop_rim": rim.mean(rim.polar()[2]),
        "radial_mid": middle.mean(middle.polar()[1]),
        "hoop_mid": middle.mean(middle.polar()[2]),
        "axial": body.mean(body.stress[3]),
    }
