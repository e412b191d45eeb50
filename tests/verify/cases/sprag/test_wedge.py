"""A wedged sprag: yields of elastic bodies, the work of the torque, and independent intervals."""

import numpy as np
import pytest

from analytic.sprag import elastic
from verify.cases.sprag.wedge.case import WEDGE, WedgedSprag
from verify.cases.sprag.wedge.figures import parts_of
from verify.cases.sprag.wedge.model import rigid_force

Q = WedgedSprag()


def test_elastic_yields_are_those_of_rings_under_single_loads_and_of_the_column():
    yields = dict(parts_of(Q, np.array([rigid_force(Q)])))
    assert sum(float(p[0]) for p in yields.values()) == pytest.approx(Q.at_share(1.0).H, rel=1e-12)
    P = rigid_force(Q) / Q.l
    a_i, a_e = (float(a) for a in Q.bodies.half_widths(np.array(rigid_force(Q))))
    for name, r_i, r_o, loaded, a in (
        ("inner", Q.R_id, Q.R_i, "rim", a_i), ("outer", Q.R_e, Q.R_ed, "bore", a_e),
    ):  # fmt: skip
        ring = elastic.LoadedRace(r_i=r_i, r_o=r_o, E=Q.E, nu=Q.nu, assumption="plane strain",
                                  loaded=loaded, n=Q.z, P=P, a=a)  # fmt: skip
        both = float(yields[f"{name} mean"][0] + yields[f"{name} dent"][0])
        assert both == pytest.approx(abs(ring.displacement(ring.r, 0.0)), rel=2e-4)


def test_a_sprag_rolls_over_where_its_flank_comes_to_the_race():
    v = WEDGE.analytic(Q)
    for share, verdict in ((0.99, "holds"), (1.01, "rolls over")):
        q = WedgedSprag(T=share * v["T_roll"])
        own = WEDGE.analytic(q)
        assert WEDGE.findings(q, own)[0].startswith(
            "rolls over: a contact reaches the sprag's flank"
            if verdict == "rolls over"
            else "holds with friction above"
        )
    assert WEDGE.summary(q, own)["verdict"] == "rolls over"
