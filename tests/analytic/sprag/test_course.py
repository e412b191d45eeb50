"""Work: the races' torque does on their turn what the yields take, for the closure as it is."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.sprag import printed
from analytic.sprag.closure import wedged
from analytic.sprag.course import energy, rolled, work

N = np.array([50.0, 500.0, 3407.0, 8000.0])
STEP = 1e-4  # relative, of central differences


def rates(clutch, state=wedged):
    """State at N, differences of the inner and the outer yields and of the races' turn."""
    more, less = (state(clutch, N * (1 + h)) for h in (STEP, -STEP))
    now = state(clutch, N)
    turn = now.OC_e * (np.cos(now.beta) / now.OA - 1 / now.OB) * (more.alpha_b - less.alpha_b)
    turn = turn + np.sin(now.beta) / now.OA * (more.OC_e - less.OC_e)
    inner, outer = more.yields.inner - less.yields.inner, more.yields.outer - less.yields.outer
    return now, inner, outer, turn


@pytest.mark.parametrize("name", ["clutch", "plane_clutch"])
def test_torque_on_turn_is_force_on_yield(name, request):
    clutch = request.getfixturevalue(name)
    now, inner, outer, turn = rates(clutch)
    assert now.T * turn == pytest.approx(12 * (now.N * inner + now.N_e * outer), rel=1e-7)
    assert now.T * turn == pytest.approx(12 * now.N * (inner + outer), rel=1e-3)


def test_the_races_turn_is_the_integral_of_its_rate(plane_clutch):
    _, _, _, turn = rates(plane_clutch)
    found = rolled(plane_clutch, N * (1 + STEP)) - rolled(plane_clutch, N * (1 - STEP))
    assert found == pytest.approx(turn, rel=1e-6)


def test_without_the_sprag_s_way_outwards_the_turn_lacks_the_work(clutch):
    """Rolling about the pole alone: nu beta/2 or so is missing."""
    now, inner, outer, turn = rates(clutch)
    more, less = (wedged(clutch, N * (1 + h)) for h in (STEP, -STEP))
    short = turn - np.sin(now.beta) / now.OA * (more.OC_e - less.OC_e)
    lost = now.T * short / (12 * (now.N * inner + now.N_e * outer)) - 1
    assert np.all((lost < -5e-4) & (lost > -1e-3))


def test_eqs_9_and_10_as_printed_lose_a_seventh_of_the_work(clutch):
    """OA with half of delta_HI and without delta_g/2 stands where the whole inner yield must."""
    now, inner, outer, turn = rates(clutch, printed.wedged)
    done = now.T * turn / (12 * (now.N * inner + now.N_e * outer))
    assert done[2] == pytest.approx(0.849, abs=0.002)
    assert np.all((done > 0.8) & (done < 0.87))


def test_the_work_of_both_forces_grows_with_the_torque_s_on_the_turn(clutch):
    more, less = N * (1 + STEP), N * (1 - STEP)
    *_, turn = rates(clutch)
    found = work(clutch, more) - work(clutch, less)
    assert 12 * found == pytest.approx(wedged(clutch, N).T * turn, rel=1e-5)


def test_the_energy_of_linear_yields_is_half_of_force_times_yield(clutch):
    law = replace(clutch.compliance, contact_i=lambda N: 0.0 * N, contact_e=lambda N: 0.0 * N)
    stiff = replace(clutch, compliance=law)
    assert energy(stiff, N) == pytest.approx(N * wedged(stiff, N).yields.H / 2, rel=1e-6)


def test_the_energy_of_palmgren_s_law_is_known_in_closed_form(clutch):
    y = clutch.compliance.yields(N)
    linear = (y.race_i + y.race_e + y.sprag) / 2
    power = (y.contact_i + y.contact_e) * 0.9 / 1.9
    assert energy(clutch, N) == pytest.approx(N * (linear + power), rel=1e-6)


def test_without_load_nothing_has_turned(clutch):
    assert rolled(clutch, [[0.0], [0.0]]) == pytest.approx(np.zeros((2, 1)), abs=1e-13)
    assert float(energy(clutch, 0.0)) == 0.0
