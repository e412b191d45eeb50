"""Loads, supports and contact forces balance; friction stays within its bound and takes energy."""

import numpy as np
import pytest

from fem.contact.along import Along
from meshes.contact.disc import half_disc
from tests.fem.contact.models import on_flat, tower

EXACT = 1e-8  # of the load


def test_what_is_loaded_above_arrives_below():
    load = np.array([1e-3, -8e-3])
    s = tower(0.5, on_floor=True, assumption="plane stress", thickness=0.3).solve(
        forces={"up.top": tuple(load)}, body_forces={"low": (0.0, -0.02)}
    )
    upper, lower = s.touches
    weight = np.array([0.0, -0.02 * 0.5 * 0.3])
    np.testing.assert_allclose(upper.force, load, atol=EXACT * 8e-3)
    np.testing.assert_allclose(lower.force, load + weight, atol=EXACT * 8e-3)
    # moments about the origin: of the load at (0.45, 1), and the weight at (0.5, 0.25)
    moment = 0.45 * load[1] - 1.0 * load[0]
    assert upper.moment() == pytest.approx(moment, abs=EXACT * 8e-3)
    assert upper.moment(on="slave") == pytest.approx(-moment, abs=EXACT * 8e-3)
    assert lower.moment() == pytest.approx(moment + 0.5 * weight[1], abs=EXACT * 8e-3)
    assert s.plane.residual < 1e-10


def test_friction_only_takes_energy_and_all_that_is_missing():
    # a roller on a flat swings in x and z out of phase; the trapezoidal rule loses nothing, for
    # each step is linear but for nodes that open or close in it, and here none does
    problem = on_flat(
        half_disc(R=10e-3, zone=0.28e-3, refine=1), friction=0.3, supports={"middle": "xy"},
        along=Along(supports={"middle": 0.0}),
    )  # fmt: skip
    s, before, lost, path = None, np.zeros((2, 1)), [], []
    for t in np.linspace(0, 4 * np.pi, 97):
        x, z = 6e-7 * np.sin(t), 6e-7 * np.sin(t - np.pi / 3)
        s = problem.solve(
            displacements={"middle": {"x": x, "y": -2e-6}}, axial_displacements={"middle": z},
            after=s,
        )  # fmt: skip
        touch = s.touches[0]
        forces = np.array([touch.traction, touch.traction_z]) * touch.mortar.size
        slips = np.array([touch.slip, touch.slip_z])
        lost.append(-float(((forces + before) * slips).sum()) / 2)
        before = forces
        path.append((x, z, touch.force[0], touch.force_z, s.strain_energy))
    x, z, F_x, F_z, energy = np.array(path).T
    assert min(lost) > -1e-12 * max(lost)
    second = slice(48, None)
    work = float(np.trapezoid(F_x[second], x[second]) + np.trapezoid(F_z[second], z[second]))
    assert work > 0.005 * np.ptp(x) * np.ptp(F_x)
    assert work - (energy[-1] - energy[48]) == pytest.approx(sum(lost[49:]), rel=1e-6)
