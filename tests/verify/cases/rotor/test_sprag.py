"""Case of the sprag clutch - rotor system: layout, ensemble, claims that can fail, figures."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.rotor import clutch_uniform
from fem.rotor.critical import critical_speeds
from fem.rotor.fitted_speeds import gradients
from fem.rotor.response import unbalance_response
from verify.cases.rotor.sprag import ensemble_fem, layout, solid_fem
from verify.cases.rotor.sprag.case import SPRAG_ROTOR, SpragRotor
from verify.cases.rotor.sprag.check_types import FittedTo, Share
from verify.cases.rotor.sprag.formulas import ORDERS
from verify.cases.rotor.sprag.inputs import PRINTED, RPM
from verify.cases.rotor.sprag.reference import beams_fem, drawn_fem, ensemble_arrays_fem
from verify.cases.rotor.sprag.response_fem import damped, responses_fem
from verify.cases.rotor.sprag.system_fem import rotor_fem, systems_fem, uneven_clutch_fem
from verify.core import units
from verify.core.case import Context, FemResult
from verify.core.results import Status
from verify.papers.ledger import erratum, published

Q = SpragRotor()
RNG = np.random.default_rng(3)
ANYWHERE = RNG.random((3, len(layout.PARAMETERS)))  # places in the ranges


@pytest.fixture(scope="module")
def found():
    return ensemble_fem.ensemble_fem(8)


def at(x):
    return systems_fem(ensemble_fem.RANGES.parameters(x))


def test_the_clutch_and_its_bearings_join_nodes_of_one_place_and_discs_are_steel_rings():
    z = layout.layout(ensemble_fem.RANGES.parameters(ANYWHERE)).z
    assert [len(rotor) for rotor in layout.ELEMENT_LENGTHS] == [11, 9]  # Sec. 1
    for a, b in (*layout.BETWEEN, layout.CLUTCH):
        assert z[:, a - 1] == pytest.approx(z[:, b - 1], rel=1e-14)
    s, bore = layout.layout(layout.CENTRAL), layout.CENTRAL[layout.D_1]
    rim = np.sqrt(4 * layout.CENTRAL[layout.M_4] / (np.pi * 7850 * 0.02) + bore**2)
    m = 7850 * 0.02 * np.pi / 4 * (rim**2 - bore**2)
    polar = m * (rim**2 + bore**2) / 8
    found = [one[0, 0] for one in (s.mass, s.polar, s.diametral)]
    assert found == pytest.approx([m, polar, polar / 2 + m * 0.02**2 / 12], rel=1e-12)


def test_an_even_clutch_is_that_of_the_closed_forms_and_an_offset_couples_in_first_order():
    K, s = uneven_clutch_fem(layout.CENTRAL, 0.0), layout.layout(layout.CENTRAL)
    k = 2 * layout.CENTRAL[layout.K_C] / 12
    tilt = float(clutch_uniform.tilting_stiffness(Z=12, k=k, L=0.012, n_s=20))
    turn = float(clutch_uniform.torsional_stiffness(Z=12, k=k, d_t=s.d_t[0]))
    across = float(clutch_uniform.radial_stiffness(Z=12, k=k))
    assert np.diag(K) == pytest.approx([across, across, 0, tilt, tilt, turn], rel=1e-12)
    size = np.sqrt(np.outer(np.diag(K), np.diag(K)))
    assert np.all(np.abs(K - np.diag(np.diag(K))) <= 1e-13 * size)
    eps = 1e-3
    first = (10 / 9 - 1) * layout.CENTRAL[layout.K_C] * s.d_t[0] * eps  # (Z/2) k (n-1) dx d_t/delta
    assert uneven_clutch_fem(layout.CENTRAL, eps)[0, 5] == pytest.approx(first, rel=eps**2)


def test_matrices_of_all_members_at_once_are_those_of_the_assembled_rotors():
    p = ensemble_fem.RANGES.parameters(ANYWHERE)
    at_once, _ = systems_fem(p).critical_speeds(3)
    each = [critical_speeds(rotor_fem(one), 3).speeds for one in p]
    assert at_once == pytest.approx(np.array(each), rel=1e-9)


def test_gradients_are_those_of_the_speeds():
    _, shapes = at(ANYWHERE).critical_speeds(3)
    J = gradients(ANYWHERE, shapes, at)
    for i, step in enumerate(1e-4 * np.eye(12)):
        up, down = (np.log(at(x).critical_speeds(3)[0]) for x in (ANYWHERE + step, ANYWHERE - step))
        assert J[:, :, i] == pytest.approx((up - down) / 2e-4, rel=1e-5, abs=1e-6)


def test_members_hit_all_three_speeds_and_stay_in_the_ranges(found):
    members = found.members
    assert len(members) >= 8
    assert np.all((members >= layout.LOW) & (members <= layout.HIGH))
    for p in members:
        speeds = critical_speeds(rotor_fem(p), 3).speeds
        assert speeds == pytest.approx(PRINTED, rel=1.1e-8)
    spread = np.log(members.max(axis=0) / members.min(axis=0)) / ensemble_fem.RANGES.width
    assert np.median(spread) > 0.4  # eight systems, and most unknowns over half of their range


@pytest.fixture(scope="module")
def context(found):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(solid_fem, "REFINED", (1, 2, 3))  # fast, and finite elements all the same
        bodies = solid_fem.solid_fem(Q)
    responses = responses_fem(Q, found.members)
    arrays = {**ensemble_arrays_fem(found), **responses, **drawn_fem(Q), **bodies}
    runs = [FemResult(h=1 / n, values=beams_fem(Q, n)) for n in (1, 2, 4)]
    runs[0] = replace(runs[0], arrays=arrays)
    return Context("rotor-sprag", Q, SPRAG_ROTOR.analytic(Q), runs, is_paper=True)


def test_unbalances_are_superposed_as_if_they_acted_together(found):
    """The x of node 11 at 10,000 r/min and the load of bearing 4, from both unbalances at once."""
    member = found.members[2]
    one = responses_fem(Q, member[None])  # its damping is that of a first member
    rotor = rotor_fem(member, damping=damped(one["zeta"][0]))
    together = unbalance_response(rotor, one["grid"], {3: 1.4e-5, 18: 3e-5})
    x, F = np.abs(together.at(10)[:, 0]), np.abs(together.link_load(1)[:, 0])
    assert one["nodes over speed"][1, 1, 2] == pytest.approx(x, rel=1e-9)
    assert one["bearings over speed"][1, 1, 1] == pytest.approx(F, rel=1e-9)


def test_backward_whirl_is_no_reading_of_orders_1_3_and_5(context):
    values = context.analytic
    swapped = {f"critical_forward_{k}": values[f"critical_backward_{k}"] for k in ORDERS}
    other = replace(context, analytic={**values, **swapped})
    fitted = [c for c in SPRAG_ROTOR.checks if isinstance(c, FittedTo)]
    assert [c.rows(context)[0].status for c in fitted] == [Status.CALIBRATED] * 3
    assert [c.rows(other)[0].status for c in fitted] == [Status.FAIL] * 3


def changed(context, **arrays):
    run = replace(context.fem[0], arrays={**context.fem[0].arrays, **arrays})
    return replace(context, fem=[run, *context.fem[1:]])


def named(name):
    return next(c for c in SPRAG_ROTOR.checks if c.name == name)


def test_unbalance_is_mass_times_length_and_no_mass():
    """The ledger's unbalanced-mass-unit: its force at 10149 r/min is 1.4e-5 kg m omega^2."""
    printed = published("huang2022:unbalance-1")
    assert printed.unit == "kg m"
    assert units.dimensions("kg m") != units.dimensions("kg")
    force = printed.value * published("huang2022:critical-speed-1").value ** 2 * RPM**2
    assert force == pytest.approx(1.4e-5 * 1062.8**2, rel=1e-4)  # 15.8 N
    assert "unbalance" in erratum("huang2022:unbalanced-mass-unit").right


def test_statements_without_peaks_or_members_are_skipped_or_fail(context):
    peaks = context.fem[0].arrays["peaks"]
    none = changed(context, peaks=np.full_like(peaks, np.nan))
    assert named("peaks of node 4 grow with unbalance 2").rows(none)[0].status is Status.SKIP
    rising = named(
        "statement that a larger unbalance 2 gives a smaller peak of node 19 at critical speed 3"
    )
    assert "in none of the 0 sets" in rising.rows(none)[0].reason
    assert rising.rows(changed(context, peaks=peaks[:, ::-1]))[0].status is Status.FAIL
    share = next(c for c in SPRAG_ROTOR.checks if isinstance(c, Share))
    empty = {key: of[:0] for key, of in context.fem[0].arrays.items()}
    assert share.rows(changed(context, **empty))[0].status is Status.FAIL
