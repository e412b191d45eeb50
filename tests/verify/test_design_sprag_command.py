"""`freewheel design` of a crown from the command line: statuses, files, the half-space check."""

import json
import re

import numpy as np
import pytest

from tests.verify.template_text import whole
from verify.answers.template import template
from verify.app.cli import run
from verify.app.commands import load as load_check
from verify.cases.registry import find
from verify.cases.sprag.peaks import peaks_fem
from verify.studies.design_sprag import outcome
from verify.studies.design_sprag.inputs import default
from verify.studies.design_sprag.model import Model
from verify.studies.design_sprag.verified import LIMIT, _check, ends_carry, unloading


def task(folder, **changes):
    """The paper's clutch with few slices and a narrow box about its optimal crown."""
    lines = {"slices": "11", "t_end": '"0.02 s"'} | changes
    text = whole(template(find("sprag-clutch"))).replace(
        'case = "sprag-clutch"', 'case = "design-sprag"'
    )
    for key, value in lines.items():
        text, found = re.subn(rf"(?m)^(# )?{key} = [^#]*", f"{key} = {value} ", text)
        if not found:
            text += f"{key} = {value}\n"
    path = folder / "task.toml"
    path.write_text(text, encoding="utf-8")
    return path


NARROW = {"K_1_range": '"2 : 3"', "K_2_range": '"0.6 : 0.7"', "z_m_range": '"12 µm : 18 µm"'}


@pytest.fixture(scope="module")
def small():
    """A search of few crowns, in this process."""
    few = {"outcome.LEVELS": 3, "outcome.MOST_JOBS": 1, "outcome.SCATTERED": 200, "search.FRESH": 8}
    with pytest.MonkeyPatch.context() as patch:
        for name, value in few.items():
            patch.setattr(f"verify.studies.design_sprag.{name}", value)
        yield patch


@pytest.fixture(scope="module")
def done(small, tmp_path_factory):
    """The small task with its folder and its cache."""
    folder = tmp_path_factory.mktemp("design")
    small.setenv("FREEWHEEL_CACHE", str(folder / "cache"))
    status = run(["design", str(task(folder, t_z='"1 µm"', **NARROW)), "--out", str(folder / "o")])
    return status, folder


@pytest.mark.slow("crowns are engaged")
def test_the_files_of_a_verified_crown_go_through_check_with_its_load(done, tmp_path, capsys):
    status, folder = done
    assert status == 0
    assert sorted(p.name for p in (folder / "o").iterdir()) == [
        "clutch.toml", "design.html", "designs.csv", "profile.csv",
    ]  # fmt: skip
    capsys.readouterr()
    assert run(["design", "--json", str(task(tmp_path, t_z='"1 µm"', **NARROW))]) == 0
    found = json.loads(capsys.readouterr().out)  # of the same task, from the store
    _, case, inputs, _ = load_check(folder / "o" / "clutch.toml")
    assert (case.id, inputs.K_1) == ("sprag-clutch", found["best"]["K_1"])
    assert inputs.z_m == pytest.approx(found["best"]["z_m_um"] * 1e-6)
    assert inputs.Q == pytest.approx(found["Q_N"]) == 3407.0
    # pressures are those of the engagement of the case
    q = default().clutch.model_copy(update={"slices": 11, "t_end": 0.02})
    best = np.array([[found["best"][k] for k in ("K_1", "K_2")] + [inputs.z_m]])
    (one,) = found["torques"]
    own = peaks_fem(q, best, [25.0], by="strips")
    assert one["N_max"] == pytest.approx(own.N_max[0, 0], rel=1e-9)
    assert one["p"] * 1e6 == pytest.approx(own.pressure[0, 0].max(), rel=5e-3)
    own = peaks_fem(q, best, [25.0])
    assert one["p_slices"] * 1e6 == pytest.approx(own.pressure[0, 0].max(), rel=1e-6)
    # what the crown gains and what its tolerance costs
    assert found["passed"] is True
    assert one["p_now"] > one["p_worst"] >= one["p"] >= one["p_least"]
    assert one["p_without"] > one["p_now"]
    assert abs(one["excess"]) < 1e-3
    for c in found["half_space"]["checks"]:
        assert c["agrees"]
        assert c["off"] == pytest.approx(c["strips"] / c["half_space"] - 1)


def test_a_limit_that_no_crown_keeps_ends_with_1(done, tmp_path, capsys):
    path = task(tmp_path, t_z='"1 µm"', p_lim='"2900 MPa"', **NARROW)
    assert run(["design", "--no-fem", str(path)]) == 1
    printed = capsys.readouterr().out
    assert "p_lim = 2900 MPa is exceeded at 25 N m" in printed
    assert "not checked by a half-space" in printed


def test_a_clutch_that_does_not_lock_ends_with_2_and_a_line(small, tmp_path, capsys):
    path = task(tmp_path, torques='["60 N m", "90 N m"]', **NARROW)
    assert run(["design", str(path)]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "under T = 60 N m the sprags roll beyond their profile" in line


# What a half-space decides


@pytest.fixture(scope="module")
def paper(small):
    """The paper's clutch at 25 N m."""
    return Model(default().clutch, (25.0,), (2.5, 0.65, 13e-6), jobs=1)


def checked(paper, crown, contacts):
    one = default()
    one = type(one)(
        one.name, one.wishes.model_copy(update={"contacts": contacts}), one.torques, one.low,
        one.high,
    )  # fmt: skip
    return _check(one, paper, paper.answers(np.array([crown])), 0, 0, "nominal")


def test_the_best_crown_by_slices_fails_on_a_half_space(paper):
    """Its ends carry, and the finer the cells the more."""
    found = checked(paper, (2.28, 0.7, 7e-6), "slices")
    assert found.end > 0
    assert not found.agrees
    assert found.off(found.judged) < -0.2
    assert found.peak > 1.1 * found.coarse
    free = unloading(paper, found)
    assert 7e-6 < free < 25e-6
    assert checked(paper, (2.28, 0.7, free), "strips").end == 0


def test_a_crown_with_free_ends_passes_by_slices_and_by_strips(paper):
    for contacts in ("slices", "strips"):
        found = checked(paper, (2.6, 0.657, 16e-6), contacts)
        assert found.end == 0
        assert found.agrees
        assert abs(found.off(found.judged)) < 0.01 < LIMIT
        assert abs(found.mid_off) < 0.01
        assert found.coarse == pytest.approx(found.peak, rel=2e-3)


def test_a_crown_is_at_the_edge_of_its_ends_where_five_per_cent_less_makes_them_carry(paper):
    N = paper.answers(np.array([[2.5, 0.65, 12e-6]])).N_max[0, 0]

    def first_free(z_m):
        crowns = np.column_stack([np.full_like(z_m, 2.5), np.full_like(z_m, 0.65), z_m])
        k = np.argmin(ends_carry(paper, crowns, np.full_like(z_m, N), 0))
        assert k > 0
        return z_m[k - 1], z_m[k]

    coarse = first_free(np.geomspace(6e-6, 24e-6, 15))
    edge = first_free(np.geomspace(*coarse, 11))[1]  # in steps of a per cent
    for share, expected in ((0.97, False), (1.02, True), (1.08, False)):
        assert outcome._on_edge(paper, np.array([2.5, 0.65, share * edge])) is expected
