"""The best crown: its rows, what turns them red, one's own clutch."""

import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.contact import crown, slices
from tests.conftest import solved
from verify.answers.template import template
from verify.cases.sprag.clutch import model as sprag_clutch_model
from verify.cases.sprag.engagement.model import gap
from verify.cases.sprag.optimum import crown_claims
from verify.cases.sprag.optimum.case import OPTIMUM_25, OPTIMUM_40, SpragOptimum, SpragOptimum40
from verify.cases.sprag.peaks import with_crown
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.core.results import Status
from verify.jobs.level import Job, judge_case

pytestmark = pytest.mark.xdist_group("sprag-optimum")
BOTH = pytest.mark.parametrize("case", [OPTIMUM_25, OPTIMUM_40], ids=lambda case: case.id)
LARGEST = "largest pressure by slices, crown with free ends"
FRESH = "surrogate at fresh designs: 0.5% in the mean, 3% at most"
ENDLESS = "the best crown by slices has no largest pressure on a half-space"
ON_K_1 = "p_max falls, then rises along K_1"


@BOTH
def test_no_row_is_red(case, judged, red):
    assert not red(judged(case))


def wrong(case, **factors):
    """Rows that are red where arrays of the finest level are what they are times a factor."""
    *coarse, finest = solved(case, case.inputs())
    arrays = dict(finest.result.arrays)
    for name, factor in factors.items():
        assert name in arrays
        arrays[name] = arrays[name] * factor
    levels = [*coarse, replace(finest, result=replace(finest.result, arrays=arrays))]
    rows = judge_case(Job(case, case.inputs(), drawn=False), levels).rows
    return {row.quantity for row in rows if row.status is Status.FAIL}


@pytest.mark.parametrize(
    ("arrays", "row"),
    [
        ({"end predicted": 1.0001}, "kriging prediction and the bordered system"),
        ({"inside deviation": 1.1}, "kriging deviation and the bordered system"),
        ({"inside left out": 1.1}, "designs left out in closed form and one by one"),
        ({"extra two": 1.006}, FRESH),
        ({"extra two": 1.006}, "kriging the end and the rest apart halves the errors"),
        ({"left out single": 10.0}, "leaving out a design hides nine tenths of one kriging's "
         "errors"),
        ({"GA value": 1.002}, "genetic algorithm and differential evolution within 0.1%"),
        ({"direct": 0.994}, "best crown and a search without surrogate within 0.5%"),
        ({"best true": 1.006}, "best crown and a search without surrogate within 0.5%"),
        ({"best true": 0.98}, "printed crown within 1% of the best one's pressure"),
        ({"Lundberg": 1.006}, "K_1 = N_max/Q within 0.5% of the best crown's pressure"),
        ({"fitted": 1.02}, "best crown at 25 N m, angle fitted"),
        ({"best true": 1.04}, "best crown at 25 N m"),
        ({"free: strips 161": 1.03}, LARGEST),
        ({"free: strips mid 161": 1.03}, "pressure at mid-length by slices, crown with free ends"),
        ({"free: strips 161": 0.997}, "largest pressure by strips, crown with free ends"),
        ({"free: strips mid 161": 1.004}, "pressure at mid-length by strips, crown with free ends"),
        ({"at hand: cells 768": 0.94}, "the printed crown bears more on a half-space than by "
         "slices"),
        ({"best: cells 768": 0.7}, ENDLESS),
        ({"best: cells 768": 0.862}, ENDLESS),  # 1.5 % more than by 512
        ({"free: cells 768": 1.06, "free: cells 512": 1.06}, "a crown with free ends bears less "
         "than the printed one on a half-space"),
    ],
)  # fmt: skip
def test_what_is_wrong_by_a_little_turns_its_row_red(arrays, row):
    assert row in wrong(OPTIMUM_25, **arrays)


def test_a_map_that_only_falls_is_told():
    shape = solved(OPTIMUM_25, SpragOptimum())[-1].result.arrays["end"].shape
    falling = 1e3 * np.linspace(2, 1, math.prod(shape)).reshape(shape)
    assert ON_K_1 in wrong(OPTIMUM_25, end=falling)


@pytest.mark.parametrize(
    ("arrays", "row"),
    [
        ({"less": 1.5}, "the best K_1 is larger than at 25 N m"),
        ({"less": 0.85}, "the best crown for 25 N m is not the best for 40 N m"),
        ({"less": 0.95}, "the best crown takes off more than at 25 N m"),
    ],
)  # fmt: skip
def test_what_grows_with_the_torque_is_told_where_it_does_not(arrays, row):
    assert row in wrong(OPTIMUM_40, **arrays)


def forget():
    model = sprag_clutch_model
    for function in (model.built, model.under):
        function.cache_clear()


def test_a_z_m_that_changes_nothing_is_told():
    p = solved(OPTIMUM_40, SpragOptimum40())[-1].result.arrays["true K_1, z_m"]
    even = np.stack([p[0].mean() / p[0], np.ones_like(p[1])])
    assert "z_m changes more than at 25 N m" in wrong(OPTIMUM_40, **{"true K_1, z_m": even})


def test_a_z_m_that_changes_more_at_the_other_torque_is_told():
    factor = np.ones_like(solved(OPTIMUM_40, SpragOptimum40())[-1].result.arrays["true K_1, z_m"])
    factor[1, :, 0] = 2
    assert "z_m changes more than at 25 N m" in wrong(OPTIMUM_40, **{"true K_1, z_m": factor})


@pytest.fixture
def faulty(monkeypatch, judged, red):
    """Break a formula; what of the case's rows turns red."""

    def broken(module, name, wrapper):
        judged(OPTIMUM_25)  # the other side stays right
        right = getattr(module, name)
        monkeypatch.setattr(module, name, lambda *a, **k: wrapper(right, *a, **k))
        forget()
        return {row.quantity for row in red(judged(OPTIMUM_25))}

    yield broken
    monkeypatch.undo()
    forget()


def test_slices_under_another_force_are_told(faulty):
    found = faulty(slices, "press", lambda right, *a, load, **k: right(*a, load=1.1 * load, **k))
    assert LARGEST in found
    assert "largest pressure of the crown at hand at rest, by slices" in found


def test_a_crown_of_half_its_depth_is_told(faulty):
    def shallow(right, *args, **given):
        return right(*args, **given | {"K_1": 0.5 * given["K_1"]})

    found = faulty(crown, "logarithmic", shallow)
    assert {LARGEST, "largest pressure of the crown at hand at rest, by slices"} <= found


def test_the_middle_of_the_slices_is_that_of_the_sprag(faulty):
    found = faulty(crown_claims, "mid", lambda _right, contact: float(contact.peak_pressure[0]))
    assert "pressure at mid-length by slices, crown with free ends" in found


def test_the_design_variables_are_the_crown_s_three():
    q = SpragOptimum()
    assert q.box.low == (q.K_1_low, q.K_2_low, q.z_m_low) == (1.0, 0.4, 5e-6)
    assert q.box.high == (q.K_1_high, q.K_2_high, q.z_m_high) == (5.0, 0.7, 25e-6)
    mine = with_crown(q, (2.0, 0.5, 1e-5))
    assert (mine.K_1, mine.K_2, mine.z_m) == (2.0, 0.5, 1e-5)


def test_crowns_are_made_for_one_load_whatever_the_torque():
    less, more = (with_crown(q, (2.0, 0.5, 1e-5)) for q in (SpragOptimum(), SpragOptimum40()))
    assert less.T != more.T
    assert gap(less) == pytest.approx(gap(more), rel=1e-12)


@BOTH
def test_its_template_is_the_paper_s_clutch(case, tmp_path):
    import tomllib

    raw = tomllib.loads(template(case))["inputs"]
    assert build(case.inputs, raw, "t").box == case.inputs().box


@pytest.mark.parametrize(
    ("raw", "said"),
    [({"K_1_low": 6.0}, "K_1_low < K_1_high, got K_1_low = 6, K_1_high = 5"),
     ({"z_m_low": "0.03 mm"}, "z_m_low < z_m_high, got z_m_low = 0.03 mm, z_m_high = 0.025 mm"),
     ({"K_2_high": 1.1}, "K_2_high"), ({"population": 11}, "a population is in pairs"),
     ({"levels": 3}, "levels")],
)  # fmt: skip
def test_a_box_that_makes_no_sense_is_refused_in_a_line(raw, said):
    import tomllib

    whole = tomllib.loads(template(OPTIMUM_25))["inputs"] | raw
    with pytest.raises(InputError) as error:
        build(SpragOptimum, whole, "t")
    assert said in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("changes", "said"),
    [({"mu_s": 0.05, "mu_c": 0.04}, "the sprags slip: no crown mends that"),
     ({"T": 5000.0}, "no state within the profile bears this torque"),
     ({"slices": 101}, "101 slices are solved anew at each load"),
     ({"t_end": 1.0}, "t_end/dt = 1e+05 is above 50000 steps"), ({}, "")],
)  # fmt: skip
def test_what_no_crown_mends_is_refused(changes, said):
    assert OPTIMUM_25.too_large(SpragOptimum(**changes)).startswith(said)


@BOTH
def test_figures_and_tables_are_of_numbers(case, judged):
    result = judged(case)
    assert not result.errors
    assert len(result.figures) >= 12
    for figure in result.figures:
        for one in getattr(figure, "curves", ()):
            assert np.isfinite(one.x).all()
            assert np.isfinite(one.y).all()
    assert [table.title for table in result.tables][:2] == [
        "Crowns and what they bear at most", "Surrogates at extra designs, as Table 2 has them",
    ]  # fmt: skip


def test_findings_say_which_load_the_crown_at_hand_suits():
    q = SpragOptimum()
    first, second = OPTIMUM_25.findings(q, OPTIMUM_25.analytic(q))
    assert first.startswith("the crown at hand is Lundberg's for 7327 N")  # 2.1507 x 3407
    assert second.startswith("at rest under T a sprag bears 3388 N")


def test_without_levels_there_is_nothing_to_show():
    q = SpragOptimum()
    context = Context(OPTIMUM_25.id, q, OPTIMUM_25.analytic(q), [], True)
    assert not OPTIMUM_25.figures(context)
    assert not OPTIMUM_25.tables(context)
