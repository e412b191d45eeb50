"""Statements of the paper evaluated for invented members with an obvious answer."""

import numpy as np
import pytest

from verify.cases.rotor.sprag.assertions import STATEMENTS

RISING = np.arange(1.0, 4.0)  # three unbalances, or three peaks


def peaks(nodes, at=slice(None)):
    """Peaks (1, 3, 3, 22) of 1 for all three unbalances, and of other heights at these nodes."""
    found = np.ones((1, 3, 3, 22))
    for node, height in nodes.items():
        found[:, :, at, node - 1] = height
    return {"peaks": found}


def first(*nodes):
    """Nodes of height 2 at critical speed 1 alone."""
    return peaks(dict.fromkeys(nodes, 2), at=0)


def over_unbalance(values, peak, node):
    """Peaks that rise with unbalance 2 but for one node at one peak."""
    found = np.ones((1, 3, 3, 22)) * RISING[None, :, None, None]
    found[0, :, peak, node - 1] = values
    return {"peaks": found}


def twisted(along_outer, along_inner):
    """Torsion (1, 3, 22) of three peaks: rotors whose ends differ by these shares."""
    torsion = np.ones((1, 3, 22))
    torsion[:, :, 11] += along_outer
    torsion[:, :, 21] += along_inner
    return {"torsion": torsion}


def falling(*heights):
    return {"torsion": np.array(heights)[None, :, None] * np.ones((1, 1, 22))}


def loads(over_u=RISING, over_peaks=RISING, over_bearings=(1.0, 2.0)):
    u, p, b = (np.asarray(a, float) for a in (over_u, over_peaks, over_bearings))
    return {"loads": (u[:, None, None] * p[:, None] * b)[None]}


def turned(ratio, inertias=(4.0, 1.0)):
    both = np.array([[[ratio] * 3, [1.0] * 3]], complex)
    return {"turned": both, "inertia": np.array([inertias])}


CASES = [
    ("node 11 has the highest peak of nodes 1 to 11 at critical speed 1",
     peaks({11: 2, 12: 3}), peaks({4: 3, 11: 2})),
    ("node 11 has the highest peak of nodes 1 to 12 (with the free end) at critical speed 1",
     peaks({11: 2}), peaks({11: 2, 12: 3})),
    ("node 11 has the highest peak of nodes 1 to 11 at critical speeds 3 and 5",
     peaks({11: 2}), first(11)),
    ("node 19 has the highest amplitude of the inner rotor at every peak",
     peaks({19: 2}), peaks({18: 3, 19: 2})),
    ("torsional rotation is uniform along both rotors at critical speeds 3 and 5",
     twisted(0.05, 0.05), twisted(0, 0.2)),
    ("peaks of node 19 at critical speeds 1 and 5 grow with unbalance 2",
     over_unbalance([3, 2, 1], 1, 19), over_unbalance([3, 2, 1], 2, 19)),
    ("amplitude of node 2 at every peak is below half the median amplitude of outer-rotor nodes "
     "without bearings to the ground",
     peaks({2: 0.4}), peaks({2: 0.6})),
    ("nodes 13 to 19 have their highest peaks at critical speed 1", first(*range(13, 20)),
     first(*range(13, 19))),
    ("torsional rotation is uniform along the outer rotor at critical speed 1", twisted(0.05, 9),
     twisted(0.2, 0)),
    ("torsional rotation is highest at critical speed 1", falling(3, 2, 1), falling(2, 1, 3)),
    ("peaks of node 4 grow with unbalance 2", over_unbalance(RISING, 2, 4),
     over_unbalance([1, 3, 2], 2, 4)),
    ("peak of node 19 at critical speed 3 is lower with unbalance 2 = 5e-5 than with 3e-5 kg m",
     over_unbalance([1, 3, 2], 1, 19), over_unbalance([3, 1, 2], 1, 19)),
    ("loads of bearings 3 and 4 grow with unbalance 2", loads(), loads(over_u=[1, 3, 2])),
    ("loads of bearings 3 and 4 are higher at higher critical speeds", loads(over_u=[3, 2, 1]),
     loads(over_peaks=[2, 1, 3])),
    ("load of bearing 4 exceeds that of bearing 3 at every peak", loads(),
     loads(over_bearings=(2, 1))),
    ("ratio of the torsional rotations of nodes 4 and 19 is −J_in/J_out within 3 % at critical "
     "speed 1",
     turned(-0.25), turned(-0.27)),
]  # fmt: skip


@pytest.mark.parametrize(("name", "holds", "fails"), CASES)
def test_a_statement_is_distinguished_from_its_opposite(name, holds, fails):
    statement = next(s for s in STATEMENTS if s.name == name)
    assert statement.holds(holds).tolist() == [True]
    assert statement.holds(fails).tolist() == [False]
    assert statement.asked(holds).tolist() == [True]
    blind = {key: np.full_like(of, np.nan) for key, of in holds.items()}
    assert statement.asked(blind).tolist() == [False]
