"""Rotors of a user: formulas against beams, readings, and computed results."""

import numpy as np
import pytest

from analytic.rotor import rotor_study, transfer_bending, transfer_model
from tests.verify.cases.rotor.system_inputs import RAW, built, changed
from verify.cases.rotor.system.case import SYSTEM, RotorSystem
from verify.cases.rotor.system.reference import solve
from verify.cases.rotor.system.transfer import inertia_of
from verify.jobs.level import Job, Solved, judge_case

# Rotors beside the default one: the formulas against beams.


def counter_rotating():
    return built(changed("shafts", 2, ratio=-1.3))


def unlike_bearings():
    raw = changed("supports", 1, kyy="25 N/µm", kxy="8 N/µm", cyy="300 N s/m")
    raw["links"][0] |= {"k_tilt": "2e4 N m/rad", "c_tilt": "3 N m s/rad", "kyy": "20 N/µm"}
    return built(raw)


def clutched():
    raw = changed("shafts", 2, drop=["ratio"])
    raw["links"][0] |= {"k_turn": "5e3 N m/rad", "k_tilt": "2e4 N m/rad"}
    return built(raw)


@pytest.mark.parametrize("make", [counter_rotating, unlike_bearings, clutched])
def test_beams_agree_on_other_rotors(make):
    q = make()
    v, (coarse, fine) = dict(SYSTEM.analytic(q)), (solve(q, level).values for level in (1, 4))
    assert v.pop("lowest") == 2 * np.pi * v["frequency_1"]
    assert set(v) == set(fine)
    for key, value in v.items():
        loads = key in ("amplitude", "support_load", "link_load")
        assert coarse[key] == pytest.approx(value, rel=1e-2 if loads else 2e-4), key
        assert fine[key] == pytest.approx(value, rel=1e-4 if loads else 2e-5), key


# Readings, and errors of the reference.


def shafts_turn_backwards(right):
    return lambda rotor, w, Omega: right(rotor, w, -np.asarray(Omega))


def unbalances(change):
    """Other unbalances, made of them and of the excitation's sense."""
    return lambda f: (
        lambda r, n, u, excitation: f(
            r, n, {node: change(v, excitation) for node, v in u.items()}, excitation=excitation
        )
    )


@pytest.mark.parametrize(
    ("owner", "name", "reading", "row"),
    [
        pytest.param(transfer_bending, "numbers", shafts_turn_backwards,
                     "natural frequency 1 at speed n", id="shafts turn backwards"),
        pytest.param(rotor_study, "transfer_unbalance_response",
                     unbalances(lambda v, e: v if e > 0 else np.conj(v)),
                     "second test rotor (anisotropic bearings): amplitude of the probe node",
                     id="conjugate unbalance on the shaft that turns against the other"),
        pytest.param(transfer_model.Spring, "stiffness", lambda f: property(
                     lambda s: (f.fget(s)[0], np.conj(f.fget(s)[1]))),
                     "second test rotor (anisotropic bearings): load of the bearing between shafts",
                     id="conjugate deviator of stiffness"),
    ],
)  # fmt: skip
def test_another_reading_fails(owner, name, reading, row, fails):
    assert row in fails(SYSTEM, owner, name, reading, row)


def as_solved(result):
    return Solved(result, "", 0.0, cached=False)


# What is computed.


def test_a_cylinder_has_its_mass_and_moments_and_what_is_given_counts_instead():
    _, _, disc, _ = RotorSystem().discs
    mass, polar, diametral = inertia_of(disc)
    ring = 0.2**2 + 0.03**2
    assert mass == pytest.approx(7850 * np.pi / 4 * (0.2**2 - 0.03**2) * 0.02)
    assert polar == pytest.approx(mass * ring / 8)
    assert diametral == pytest.approx(mass * (ring / 16 + 0.02**2 / 12))
    raw = changed("discs", 3, mass="10 kg", polar="0.05 kg m^2")
    mass, polar, diametral = inertia_of(built(raw).discs[2])
    assert (mass, polar) == (10.0, 0.05)
    assert diametral == pytest.approx(10 * (ring / 16 + 0.02**2 / 12))
    assert solve(built(raw), 1).values["frequency_3"] == pytest.approx(
        SYSTEM.analytic(built(raw))["frequency_3"], rel=2e-4
    )


def test_a_rotor_without_links_or_unbalances_has_fewer_rows(red):
    raw = changed(shafts=[{"name": "outer"}], links=[], unbalances=[], discs=RAW["discs"][:2],
                  segments=RAW["segments"][:4], probe=1)  # fmt: skip
    raw["supports"] = [{"node": 1, "k": "60 N/µm"}, {"node": 5, "k": "60 N/µm"}]
    q = built(raw)
    result = judge_case(Job(SYSTEM, q), [as_solved(solve(q, n)) for n in SYSTEM.levels])
    assert not red(result)
    quantities = {row.quantity for row in result.rows}
    assert "critical speed 1 excited by the unbalance of the first shaft" in quantities
    assert (
        not {"amplitude of the probe node", "load of the first bearing between shafts"} & quantities
    )
