"""Case of the sprag clutch - rotor system: layout, ensemble, claims that can fail, figures."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.rotor import clutch_uniform
from fem.fourier.inertia import rigid_inertia
from fem.rotor import ensemble, fitted_speeds
from fem.rotor.fitted_speeds import fitted, gradients
from verify.cases.rotor.sprag import ensemble_fem, layout, solid_fem
from verify.cases.rotor.sprag.case import SPRAG_ROTOR, SpragRotor
from verify.cases.rotor.sprag.check_types import FittedTo, Share
from verify.cases.rotor.sprag.claims import IDENTITIES
from verify.cases.rotor.sprag.elastic import drawn
from verify.cases.rotor.sprag.formulas import ORDERS
from verify.cases.rotor.sprag.inputs import PRINTED, RPM
from verify.cases.rotor.sprag.reference import beams_fem, drawn_fem, ensemble_arrays_fem
from verify.cases.rotor.sprag.response_fem import (
    damped,
    damping_ratios_fem,
    responses_fem,
    torsion_fem,
    windows,
)
from verify.cases.rotor.sprag.system_fem import rotor_fem, systems_fem, uneven_clutch_fem
from verify.core import units
from verify.core.case import Context, FemResult
from verify.core.inputs import InputError, build
from verify.core.results import Status
from verify.papers.ledger import erratum, published

Q = SpragRotor()
RNG = np.random.default_rng(3)
IDENTICAL = [c for c in SPRAG_ROTOR.checks if c.name in {one.name for one in IDENTITIES}]
ANYWHERE = RNG.random((3, len(layout.PARAMETERS)))  # places in the ranges


@pytest.fixture(scope="module")
def found():
    return ensemble_fem.ensemble_fem(8)


@pytest.fixture(scope="module")
def members(found):
    return found.members


def at(x):
    return systems_fem(ensemble_fem.RANGES.parameters(x))


# Layout.


def test_the_clutch_and_its_bearings_join_nodes_of_one_place():
    z = layout.layout(ensemble_fem.RANGES.parameters(ANYWHERE)).z
    for a, b in (*layout.BETWEEN, layout.CLUTCH):
        assert z[:, a - 1] == pytest.approx(z[:, b - 1], rel=1e-14)


def test_both_rotors_have_the_printed_numbers_of_elements():
    outer, inner = layout.ELEMENT_LENGTHS
    assert (len(outer), len(inner)) == (11, 9)  # Sec. 1
    # from bearing to bearing: all of l_1, l_2, l_3 and l_4
    for rotor, parameter, first, last in (
        (0, layout.L_1, 1, 5), (0, layout.L_2, 5, 8), (0, layout.L_3, 8, 10), (1, layout.L_4, 3, 8),
    ):  # fmt: skip
        chosen = layout.ELEMENT_LENGTHS[rotor][first:last]
        assert {which for which, _ in chosen} == {parameter}
        assert sum(share for _, share in chosen) == pytest.approx(1, abs=1e-15)


def test_a_disc_is_a_steel_ring_on_its_shaft():
    s = layout.layout(layout.CENTRAL)
    bore = layout.CENTRAL[layout.D_1]
    rim = np.sqrt(4 * layout.CENTRAL[layout.M_4] / (np.pi * 7850 * 0.02) + bore**2)
    m = 7850 * 0.02 * np.pi / 4 * (rim**2 - bore**2)
    assert s.mass[0, 0] == pytest.approx(m, rel=1e-12)
    assert s.polar[0, 0] == pytest.approx(m * (rim**2 + bore**2) / 8, rel=1e-12)
    assert s.diametral[0, 0] == pytest.approx(s.polar[0, 0] / 2 + m * 0.02**2 / 12, rel=1e-12)


def test_the_inner_rotor_begins_inside_the_drum_whatever_the_lengths():
    z = layout.layout(ensemble_fem.RANGES.parameters(RNG.integers(0, 2, (64, 12)).astype(float))).z
    assert np.all(z[:, 12] > z[:, 7])  # node 13 behind the drum's bottom at node 8


# Clutch.


def test_an_even_clutch_is_that_of_the_closed_forms():
    K = uneven_clutch_fem(layout.CENTRAL, 0.0)
    s = layout.layout(layout.CENTRAL)
    k = 2 * layout.CENTRAL[layout.K_C] / 12
    tilt = float(clutch_uniform.tilting_stiffness(Z=12, k=k, L=0.012, n_s=20))
    turn = float(clutch_uniform.torsional_stiffness(Z=12, k=k, d_t=s.d_t[0]))
    across = float(clutch_uniform.radial_stiffness(Z=12, k=k))
    assert np.diag(K) == pytest.approx([across, across, 0, tilt, tilt, turn], rel=1e-12)
    size = np.sqrt(np.outer(np.diag(K), np.diag(K)))
    off = K - np.diag(np.diag(K))
    assert np.all(np.abs(off) <= 1e-13 * size)
    assert (s.k_tilt[0], s.k_turn[0]) == pytest.approx((tilt, turn), rel=1e-12)


def test_an_offset_couples_as_in_first_order():
    eps = 1e-3
    s = layout.layout(layout.CENTRAL)
    first = (10 / 9 - 1) * layout.CENTRAL[layout.K_C] * s.d_t[0] * eps  # (Z/2) k (n-1) dx d_t/delta
    assert uneven_clutch_fem(layout.CENTRAL, eps)[0, 5] == pytest.approx(first, rel=eps**2)


# Ensemble.


def test_matrices_of_all_members_at_once_are_those_of_the_assembled_rotors():
    from fem.rotor.critical import critical_speeds

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


def test_stiffer_supports_raise_critical_speeds():
    """Rayleigh: stiffness never lowers a frequency, and raises it by its share of the energy."""
    J = ensemble_fem.elasticities_fem(ensemble_fem.RANGES.parameters(ANYWHERE))
    stiffness = J[:, :, [layout.K_G, layout.K_S, layout.K_C]]
    assert np.all(stiffness >= -1e-9)
    assert np.all(stiffness.sum(axis=2) <= 0.5)  # their share of the elastic energy, halved
    up = ensemble_fem.RANGES.parameters(ANYWHERE)
    up[:, layout.K_G] *= 1.01
    raised, _ = systems_fem(up).critical_speeds(3)
    before, _ = at(ANYWHERE).critical_speeds(3)
    expected = np.log(raised / before) / np.log(1.01)
    assert J[:, :, layout.K_G] == pytest.approx(expected, rel=0.01, abs=1e-4)


def test_the_central_system_is_where_the_middle_of_the_ranges_leads_to():
    x, hit = fitted(np.full((1, 12), 0.5), PRINTED, at)
    assert hit.all()
    # six digits of it are kept
    assert ensemble_fem.RANGES.parameters(x)[0] == pytest.approx(layout.CENTRAL, rel=5e-6)


def test_members_hit_all_three_speeds_and_stay_in_the_ranges(members):
    from fem.rotor.critical import critical_speeds

    assert len(members) >= 8
    assert np.all((members >= layout.LOW) & (members <= layout.HIGH))
    for p in members:
        speeds = critical_speeds(rotor_fem(p), 3).speeds
        assert speeds == pytest.approx(PRINTED, rel=1.1e-8)
    spread = np.log(members.max(axis=0) / members.min(axis=0)) / ensemble_fem.RANGES.width
    assert np.median(spread) > 0.4  # eight systems, and most unknowns over half of their range


def test_the_ensemble_is_the_same_every_time(members):
    assert np.array_equal(ensemble_fem.ensemble_fem(8).members, members)


def test_starts_that_miss_are_no_members(monkeypatch):
    monkeypatch.setattr(fitted_speeds, "STEPS", 1)
    monkeypatch.setattr(ensemble, "MOST_BATCHES", 1)
    found = ensemble_fem.ensemble_fem(8)
    assert not found.kept.any()
    assert found.members.shape == (0, 12)


def test_damping_ratios_are_within_their_range_and_even():
    zeta = damping_ratios_fem(Q, 200)
    assert np.all((zeta[:, 0] >= 0.005) & (zeta[:, 0] <= 0.03))
    assert np.median(zeta[:, 0]) == pytest.approx(np.sqrt(0.005 * 0.03), rel=0.02)
    apart = zeta[:, 1] / zeta[:, 0]
    frequencies = PRINTED[2] / PRINTED[0]
    assert np.all((apart < frequencies) & (apart > 1 / frequencies))


# Responses.


@pytest.fixture(scope="module")
def responses(members):
    return responses_fem(Q, members)


def test_unbalances_are_superposed_as_if_they_acted_together(members):
    """The x of node 11 at 10,000 r/min and the load of bearing 4, from both unbalances at once."""
    from fem.rotor.response import unbalance_response

    i = 2
    one = responses_fem(Q, members[i : i + 1])  # its damping is that of a first member
    rotor = rotor_fem(members[i], damping=damped(one["zeta"][0]))
    together = unbalance_response(rotor, one["grid"], {3: 1.4e-5, 18: 3e-5})
    x, F = np.abs(together.at(10)[:, 0]), np.abs(together.link_load(1)[:, 0])
    assert one["nodes over speed"][1, 1, 2] == pytest.approx(x, rel=1e-9)
    assert one["bearings over speed"][1, 1, 1] == pytest.approx(F, rel=1e-9)


def test_an_unbalance_moved_to_node_11_is_one_there(members):
    from fem.rotor.response import unbalance_response

    one = responses_fem(Q, members[:1])
    zeta = one["zeta"][0]
    rotor = rotor_fem(members[0], damping=damped(zeta))
    for key, unbalances in (
        ("peaks, moved", {10: 1.4e-5, 18: 1e-5}), ("peaks, opposite", {3: 1.4e-5, 18: -1e-5}),
    ):  # fmt: skip
        both = unbalance_response(rotor, windows(zeta).ravel(), unbalances)
        near = np.abs(both.at(3)[:, 0]).reshape(3, -1)
        found = one[key][0].reshape(-1, 3, 22)[0, :, 3]
        assert np.isfinite(found[0])
        for peak, at in zip(found, near, strict=True):
            assert np.isnan(peak) or np.abs(at - peak).min() < 1e-9 * peak
        assert found[0] == pytest.approx(near[0].max(), rel=1e-9)


def test_peaks_stand_above_what_is_seen_over_the_speed(responses):
    over = responses["nodes over speed"][0, 0]  # 5 % of members: below the highest peaks anyway
    nodes = [n - 1 for n in (4, 6, 11, 16, 19, 21)]
    highest = responses["peaks"][:, 0][:, :, nodes]
    assert np.all(np.nanmax(highest, axis=(0, 1)) > over.max(axis=1))


def test_momentum_of_torsion_is_that_of_rigid_rotors_where_both_are_stiff():
    """Theta is -J_in/J_out inverted at critical speed 1 where each rotor turns as a whole."""
    p = layout.CENTRAL.copy()
    p[[layout.L_1, layout.L_2, layout.L_3, layout.L_4]] /= 4
    p[[layout.D_1, layout.D, layout.D_2]] *= 2
    zeta = np.array([1e-4, 1e-4])
    one = torsion_fem(Q, p, zeta, rotor_fem(p, damping=damped(zeta)))
    J, theta = one["inertia"], one["turned"][:, 0]
    for own in (slice(12), slice(12, None)):
        along = one["torsion"][0, own]
        assert np.ptp(along) < 0.01 * along.mean()
    assert (theta[0] / theta[1]).real == pytest.approx(-J[1] / J[0], rel=0.01)
    assert abs((theta[0] / theta[1]).imag) < 0.01 * J[1] / J[0]


def test_elastic_bodies_with_the_same_springs_and_discs_have_about_the_beams_frequencies(
    values, monkeypatch
):
    """Within 1 % on a coarse mesh: a spring or disc left out changes some of them by more."""
    monkeypatch.setattr(solid_fem, "REFINED", (2,))
    found = solid_fem.solid_fem(Q)["solid"][0]
    beams = [values[f"frequency_{i + 1}"] for i in range(6)]
    assert found == pytest.approx(beams, rel=0.005)


def test_beams_and_elastic_bodies_lose_the_same_inertia_with_a_disc(monkeypatch):
    """A disc of 1.1 kg that only the bodies lack: 1.1 of 6.8 kg, and polar moment of it."""
    s = layout.layout(layout.CENTRAL)
    whole = rigid_inertia(solid_fem.body_fem(1, 0.01))
    assert whole == pytest.approx(drawn(), rel=1e-11)
    monkeypatch.setattr(solid_fem, "DISCS", ())
    bare = rigid_inertia(solid_fem.body_fem(1, 0.01))
    z = s.z[0, [n - 1 for n in layout.DISCS]]
    lost = [s.mass.sum(), s.polar.sum(), (s.diametral + s.mass * z**2).sum()]
    assert whole - bare == pytest.approx(lost, rel=1e-10)


# The case.


@pytest.fixture(scope="module")
def values():
    return SPRAG_ROTOR.analytic(Q)


@pytest.fixture(scope="module")
def context(values, found, responses):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(solid_fem, "REFINED", (1, 2, 3))  # fast, and finite elements all the same
        bodies = solid_fem.solid_fem(Q)
    arrays = {**ensemble_arrays_fem(found), **responses, **drawn_fem(Q), **bodies}
    runs = [FemResult(h=1 / n, values=beams_fem(Q, n)) for n in (1, 2, 4)]
    runs[0] = replace(runs[0], arrays=arrays)
    return Context("rotor-sprag", Q, values, runs, is_paper=True)


def rows(context, check):
    return {row.quantity: row for row in check.rows(context)}


@pytest.mark.parametrize("check", [c for c in SPRAG_ROTOR.checks if c not in IDENTICAL],
                         ids=lambda c: c.name)  # fmt: skip
def test_claims_stand_on_a_small_ensemble(context, check):
    for row in check.rows(context):
        assert row.status in (Status.PASS, Status.CALIBRATED, Status.NOTE, Status.SHOWN), row.reason


def test_beams_go_to_the_exact_model_with_order_two(context):
    for check in IDENTICAL[:12]:
        row = check.rows(context)[1]
        assert row.status is Status.PASS, row.reason


def test_another_shear_coefficient_turns_the_frequencies_red(context, values):
    """0.9 of kappa changes frequencies 3 to 6 by far more than beams err."""
    red = replace(context, analytic={k: v * (1 + 2e-5) for k, v in values.items()})
    assert all(c.rows(red)[0].status is Status.FAIL for c in IDENTICAL[:6])


def test_backward_whirl_is_no_reading_of_orders_1_3_and_5(context, values):
    swapped = {f"critical_forward_{k}": values[f"critical_backward_{k}"] for k in ORDERS}
    other = replace(context, analytic={**values, **swapped})
    fitted = [c for c in SPRAG_ROTOR.checks if isinstance(c, FittedTo)]
    assert [c.rows(context)[0].status for c in fitted] == [Status.CALIBRATED] * 3
    assert [c.rows(other)[0].status for c in fitted] == [Status.FAIL] * 3


def test_members_fitted_on_another_mesh_than_the_paper_s_miss_its_speeds(context, found):
    from fem.rotor.critical import critical_speeds

    finer = [critical_speeds(rotor_fem(p, refine=2), 3).speeds for p in found.members]
    other = changed(context, **{"critical, forward": np.array(finer)})
    assert (
        named("every set of parameters has the three printed speeds").rows(other)[0].status
        is Status.FAIL
    )


def changed(context, **arrays):
    run = replace(context.fem[0], arrays={**context.fem[0].arrays, **arrays})
    return replace(context, fem=[run, *context.fem[1:]])


def named(name):
    return next(c for c in SPRAG_ROTOR.checks if c.name == name)


def larger(array, at, by):
    array = array.copy()
    array[at] *= by
    return array


@pytest.mark.parametrize(
    ("name", "key", "change"),
    [
        ("every set of parameters has the three printed speeds", "critical, forward",
         lambda a: larger(a, (0, 1), 1 + 2e-8)),
        ("amplitudes are convex in unbalance 2, each solved", "convex",
         lambda a: a + 1e-8 + abs(a).max()),
        ("orbits are circles on isotropic supports", "axes, isotropic",
         lambda a: larger(a, (0, 0, 1), 1 - 1e-8)),
        ("no torsion without offset", "torsion, no offset", lambda a: a + 1e-9),
        ("angular momenta of both rotors balance", "momenta", lambda a: larger(a, (0, 0), 300)),
        ("torsion is linear in small offsets", "torsion, small offsets",
         lambda a: larger(a, (0, 1), 1.02)),
        *((f"{what} of the elastic bodies with discs", "solid, inertia",
           lambda a, i=i: larger(a, i, 1 + 1e-10))
          for i, what in ((0, "mass"), (1, "polar moment of inertia"))),
        ("diametral moment of inertia about node 1 of the elastic bodies with discs",
         "solid, inertia", lambda a: larger(a, 2, 1 + 1e-10)),
        ("peak 3 of node 19 over unbalance 2", "peaks",
         lambda a: larger(a, (slice(None), 2, 1, 18), 0.1)),
        ("elliptical orbits", "axes, isotropic", lambda a: larger(a, (..., 1), 0.9)),
        ("torsional resonance at bending critical speeds", "torsion, no offset",
         lambda a: a + 1e-6),
    ],
)  # fmt: skip
def test_a_claim_fails_where_what_it_says_is_not_so(context, name, key, change):
    check = named(name)
    broken = changed(context, **{key: change(context.fem[0].arrays[key])})
    assert check.rows(context)[0].status in (Status.PASS, Status.NOTE)
    assert check.rows(broken)[0].status is Status.FAIL


def test_frequencies_at_the_critical_speed_itself_would_be_no_contradiction(context, values):
    same = {f"frequency_{2 * i + 2}": values[f"critical_forward_{k}"] / (2 * np.pi)
            for i, k in enumerate(ORDERS)}  # fmt: skip
    other = replace(context, analytic={**values, **same})
    check = named("critical speeds at 5000 r/min")
    assert check.rows(context)[0].status is Status.NOTE
    assert check.rows(other)[0].status is Status.FAIL


def test_where_no_peak_rises_nothing_is_said_to_contradict(context):
    check = named("peak 3 of node 19 over unbalance 2")
    falling = changed(context, peaks=context.fem[0].arrays["peaks"][:, ::-1])
    none = changed(context, peaks=np.full_like(context.fem[0].arrays["peaks"], np.nan))
    assert check.rows(none)[0].status is Status.FAIL
    assert "in none of 0 sets" in check.rows(none)[0].reason
    assert check.rows(falling)[0].status is Status.FAIL


def test_a_statement_that_no_set_can_be_asked_is_skipped(context):
    none = changed(context, peaks=np.full_like(context.fem[0].arrays["peaks"], np.nan))
    check = named("peaks of node 4 grow with unbalance 2")
    assert check.rows(none)[0].status is Status.SKIP


def test_a_statement_without_members_fails(context):
    check = next(c for c in SPRAG_ROTOR.checks if isinstance(c, Share))
    empty = {k: v[:0] for k, v in context.fem[0].arrays.items()}
    assert check.rows(changed(context, **empty))[0].status is Status.FAIL


def test_claims_about_the_paper_s_words_are_silent_on_own_inputs(context):
    own = replace(context, is_paper=False)
    for name in ("node of unbalance 1", "critical speed 1, central system"):
        assert named(name).rows(own) == []


@pytest.mark.parametrize("check", SPRAG_ROTOR.checks, ids=lambda c: c.name)
def test_own_loads_turn_no_claim_red(context, check):
    own = replace(context, is_paper=False)
    assert all(row.status is not Status.FAIL for row in check.rows(own))


def test_every_result_and_claim_of_the_paper_has_a_row(context):
    said = {ref for c in SPRAG_ROTOR.checks for ref in getattr(c, "printed", ())}
    from verify.papers.ledger import papers

    paper = next(p for p in papers() if p.key == "huang2022")
    wanted = {f"huang2022:{v.id}" for v in paper.values if v.role in ("result", "claim")}
    assert wanted <= said


def test_unbalance_is_mass_times_length_and_no_mass():
    """The ledger's unbalanced-mass-unit: its force at 10149 r/min is 1.4e-5 kg m omega^2."""
    printed = published("huang2022:unbalance-1")
    assert printed.unit == "kg m"
    assert units.dimensions("kg m") != units.dimensions("kg")
    force = printed.value * published("huang2022:critical-speed-1").value ** 2 * RPM**2
    assert force == pytest.approx(1.4e-5 * 1062.8**2, rel=1e-4)  # 15.8 N
    assert "unbalance" in erratum("huang2022:unbalanced-mass-unit").right


def test_it_draws_bands_and_tables(context):
    figures = SPRAG_ROTOR.figures(context)
    assert {type(f).__name__ for f in figures} == {
        "Campbell", "Whirl", "Curves", "Shapes", "Parallel",
    }  # fmt: skip
    table_1, facts, unknowns, slopes = SPRAG_ROTOR.tables(context)
    assert len(table_1.rows) == 6
    assert len(unknowns.rows) == len(slopes.rows) == 12
    assert all(" of " in str(row[2]) for row in facts.rows)


def test_without_finite_elements_it_says_what_is_unknown(values):
    bare = Context("rotor-sprag", Q, values, (), is_paper=True)
    assert SPRAG_ROTOR.figures(bare) == ()
    assert [t.title[:20] for t in SPRAG_ROTOR.tables(bare)] == ["What the paper lacks"]


# Inputs.


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"zeta_low": "4 %"}, "zeta_low <= zeta_high"),
        ({"U_2": "4e-5 kg m"}, "unbalances 2 rise"),
        ({"members": 4}, "at least 8"),
        ({"offset": 1.5}, "at most 0.9"),
        ({"offset": 0}, "at least 0.001"),
        ({"rig_speed": "0 r/min"}, "at least 2000 r/min"),
    ],
)
def test_inputs_that_make_no_sense_are_refused(change, message):
    raw = {"members": 48, "zeta_low": "0.5 %", "zeta_high": "3 %", "U_1": "1.4e-5 kg m",
           "U_2": "1e-5 kg m", "U_2_middle": "3e-5 kg m", "U_2_high": "5e-5 kg m",
           "speed": "5000 r/min", "rig_speed": "7000 r/min", "u_rig_1": "7e-5 kg m",
           "u_rig_2": "6e-5 kg m", "T": "15 N m", "offset": 0.2, "anisotropy": 0.2}  # fmt: skip
    build(SpragRotor, raw, "file")
    with pytest.raises(InputError, match=message):
        build(SpragRotor, raw | change, "file")
