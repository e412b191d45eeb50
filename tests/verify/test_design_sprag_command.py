"""`freewheel design` of a crown as a user meets it: statuses, files, a half-space's verdict."""

import csv
import json
import re
import subprocess
import sys

import numpy as np
import pytest

from tests.verify.template_text import whole
from verify.answers.template import template
from verify.app.cli import run
from verify.app.commands import load as load_check
from verify.cases.registry import find
from verify.cases.sprag.peaks import peaks_fem
from verify.studies.design_sprag import model, outcome, search
from verify.studies.design_sprag.inputs import default
from verify.studies.design_sprag.model import Model
from verify.studies.design_sprag.verified import LIMIT, _check, ends_carry, unloading

HEAVY = ("gmsh", "skfem", "meshio", "pyvista", "matplotlib", "sklearn", "numba")


def task(folder, **changes):
    """The paper's clutch with few slices and a narrow box about its best crown."""
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
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(outcome, "LEVELS", 3)
        patch.setattr(outcome, "MOST_JOBS", 1)
        patch.setattr(outcome, "SCATTERED", 200)
        patch.setattr(search, "FRESH", 8)
        yield patch


@pytest.fixture(scope="module")
def done(small, tmp_path_factory):
    """The small task with its folder and its cache."""
    folder = tmp_path_factory.mktemp("design")
    small.setenv("FREEWHEEL_CACHE", str(folder / "cache"))
    status = run(["design", str(task(folder, t_z='"1 µm"', **NARROW)), "--out", str(folder / "o")])
    return status, folder


@pytest.fixture(scope="module")
def told(done, tmp_path_factory):
    """The record of the same task, from what is kept."""
    folder = tmp_path_factory.mktemp("told")
    path = task(folder, t_z='"1 µm"', **NARROW)
    code, said = _captured(["design", "--json", str(path)])
    assert code == 0
    return json.loads(said)


def _captured(arguments):
    import contextlib
    import io

    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        return run(arguments), out.getvalue()


def test_a_verified_crown_ends_with_0_and_leaves_four_whole_files(done):
    status, folder = done
    assert status == 0
    assert sorted(p.name for p in (folder / "o").iterdir()) == [
        "clutch.toml", "design.html", "designs.csv", "profile.csv",
    ]  # fmt: skip


def test_the_same_task_again_engages_nothing_and_finds_the_same_crown(done, told, monkeypatch):
    monkeypatch.setattr(model, "some_fem", None)
    kept = (done[1] / "o" / "clutch.toml").read_text("utf-8")
    assert f"K_1 = {told['best']['K_1']!r}" in kept
    assert f"K_2 = {told['best']['K_2']!r}" in kept


def test_the_clutch_file_goes_through_check_with_the_crown_and_its_load(done, told):
    _, case, inputs, _ = load_check(done[1] / "o" / "clutch.toml")
    assert case.id == "sprag-clutch"
    assert told["best"]["K_1"] == inputs.K_1
    assert inputs.z_m == pytest.approx(told["best"]["z_m_um"] * 1e-6)
    assert inputs.Q == pytest.approx(told["Q_N"]) == 3407.0
    assert inputs.slices == 11


def test_its_pressures_are_those_of_an_engagement_by_the_commands_of_the_case(done, told):
    """Slices of the case's own engagement, and 81 strips of its own."""
    q = default().clutch.model_copy(update={"slices": 11, "t_end": 0.02})
    best = np.array([[told["best"][k] for k in ("K_1", "K_2")] + [told["best"]["z_m_um"] * 1e-6]])
    (one,) = told["torques"]
    own = peaks_fem(q, best, [25.0], by="strips")
    assert one["N_max"] == pytest.approx(own.N_max[0, 0], rel=1e-9)
    assert one["p"] * 1e6 == pytest.approx(own.pressure[0, 0].max(), rel=5e-3)
    own = peaks_fem(q, best, [25.0])
    assert one["p_slices"] * 1e6 == pytest.approx(own.pressure[0, 0].max(), rel=1e-6)


def test_the_record_says_what_the_crown_gains_and_what_its_tolerance_costs(told):
    (one,) = told["torques"]
    assert told["passed"] is True
    assert one["p_now"] > one["p_worst"] >= one["p"] >= one["p_least"]
    assert one["p_without"] > one["p_now"]
    assert abs(one["excess"]) < 1e-3
    assert one["N_max_over_Q"] == pytest.approx(one["N_max"] / 3407.0)
    assert {c["crown"] for c in told["half_space"]["checks"]} >= {"wanted"}
    for c in told["half_space"]["checks"]:
        assert c["agrees"]
        assert c["off"] == pytest.approx(c["strips"] / c["half_space"] - 1)
    low, high = told["flat"]["alone"]["low"], told["flat"]["alone"]["high"]
    assert low["K_1"] <= told["best"]["K_1"] <= high["K_1"]


def test_no_crown_that_engaged_is_better_than_the_best(done, told):
    """Of those whose ends carry nothing, at the wanted shape."""
    with (done[1] / "o" / "designs.csv").open(encoding="utf-8") as file:
        lines = list(csv.DictReader(file))
    assert len(lines) == told["kriging"]["crowns"]
    free = [line for line in lines if float(line["p end strip [MPa] at 25 N m"]) == 0]
    p = min(float(line["p strips [MPa] at 25 N m"]) for line in free)
    assert told["torques"][0]["p_least"] <= 1.002 * p


def test_the_profile_to_grind_is_the_crown_with_its_tolerance(done, told):
    with (done[1] / "o" / "profile.csv").open(encoding="utf-8") as file:
        rows = np.array([[float(x) for x in row] for row in list(csv.reader(file))[1:]])
    y, z, least, largest = rows.T
    assert (y[0], y[-1]) == (-4.5, 4.5)
    assert z[0] == pytest.approx(told["best"]["z_m_um"], rel=1e-5)
    assert z == pytest.approx(z[::-1])
    assert np.all(z[abs(y) < 4.5 * (1 - told["best"]["K_2"]) - 0.06] == 0)
    assert largest[0] - z[0] == pytest.approx(1.0, rel=1e-4)
    crowned = z > 0.01  # the whole profile grows as its end does
    assert largest[crowned] / z[crowned] == pytest.approx(largest[0] / z[0], rel=1e-3)
    assert least[crowned] / z[crowned] == pytest.approx(least[0] / z[0], rel=1e-3)


def test_the_page_is_whole_and_loads_nothing(done):
    text = (done[1] / "o" / "design.html").read_text(encoding="utf-8")
    assert text.rstrip().endswith("</html>")
    assert "http" not in text.replace("http://www.w3.org/2000/svg", "").replace("http-equiv", "")
    assert "<script" not in text
    assert "nan" not in re.sub(r"<style>.*?</style>", "", text, flags=re.DOTALL)
    for section in ("chosen", "front", "checks", "pictures", "how", "task"):
        assert f'id="{section}"' in text
    assert "freewheel design --out o task.toml\nfreewheel check --dynamic o/clutch.toml" in text
    assert text.count("<svg") == 6  # the sprag and five pictures
    assert "spring" not in re.sub(r"<style>.*?</style>", "", text).replace("springs", "").replace(
        "energising spring", ""
    )


def test_a_limit_that_no_crown_keeps_ends_with_1(done, tmp_path, capsys):
    path = task(tmp_path, t_z='"1 µm"', p_lim='"2900 MPa"', **NARROW)
    assert run(["design", "--no-fem", str(path)]) == 1
    told = capsys.readouterr().out
    assert "p_lim = 2900 MPa is exceeded at 25 N m" in told
    assert "not checked by a half-space" in told


def test_the_paper_s_way_ends_with_1_where_ends_carry_and_says_so(
    small, tmp_path, capsys, monkeypatch
):
    """Crowns of about 10 µm: their largest pressures agree, which is why the ends are asked."""
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))
    shallow = {"K_1_range": '"2.6 : 2.9"', "K_2_range": '"0.68 : 0.7"',
               "z_m_range": '"9.5 µm : 10.2 µm"'}  # fmt: skip
    path = task(tmp_path, contacts='"slices"', slices="41", t_z='"0 mm"', t_y='"0 mm"', **shallow)
    assert run(["design", str(path), "--out", str(tmp_path / "o")]) == 1
    (line,) = [x for x in capsys.readouterr().out.splitlines() if x.startswith("FAIL")]
    assert "its ends carry (25 N m, wanted)" in line
    assert abs(float(re.search(r"at most ([+-][\d.]+) %", line)[1])) < 100 * LIMIT
    page = (tmp_path / "o" / "design.html").read_text(encoding="utf-8")
    assert "off a half-space at most; its ends carry" in page


def test_an_interrupted_search_keeps_its_crowns_and_goes_on(small, tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))
    count = []

    def stopped(work):
        if len(count) == 3:
            raise KeyboardInterrupt
        count.append(work)
        return true(work)

    true = model.some_fem
    monkeypatch.setattr(model, "some_fem", stopped)
    monkeypatch.setattr(model, "key", lambda work: kept(work[:3]))
    path = task(tmp_path, **NARROW)
    assert run(["design", "--no-fem", str(path)]) == 130
    said = capsys.readouterr().err
    assert re.search(r"interrupted; \d+ of \d+ crowns are stored: the same command", said)
    done, count[:] = list(count), [None] * 4
    monkeypatch.setattr(model, "some_fem", lambda work: count.append(work) or true(work))
    assert run(["design", "--no-fem", str(path)]) == 0
    assert not [work for work in count[4:] if work in done]


def kept(work):
    import hashlib

    return hashlib.sha256(repr(work).encode()).hexdigest()


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"mu_s": "0.05", "mu_c": "0.05"}, "under T = 25 N m it slips"),
        ({"torques": '["60 N m", "90 N m"]'}, "under T = 60 N m the sprags leave their profile"),
        ({"t_end": '"0.001 s"'}, "under T = 25 N m the force still rises at the end"),
    ],
)
def test_a_clutch_that_does_not_lock_ends_with_2_and_a_line(small, tmp_path, capsys, changes, said):
    assert run(["design", str(task(tmp_path, **(NARROW | changes)))]) == 2
    told = capsys.readouterr().err
    assert said in told
    assert "fault of the program" not in told
    assert told.count("\n") == 1


def test_a_place_that_cannot_be_written_is_told_before_the_work(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert run(["design", str(task(tmp_path)), "--out", str(tmp_path / "file" / "x")]) == 2
    assert "file: is a file, expected a folder" in capsys.readouterr().err


def test_neither_help_nor_a_template_loads_anything_heavy():
    code = f"""
import sys
from verify.app.cli import run
for words in (["--help"], ["design", "--help"], ["init", "design-sprag"]):
    assert run(words) == 0
print([m for m in {HEAVY!r} if m in sys.modules], file=sys.stderr)
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=120
    )
    assert done.stderr.strip().endswith("[]"), done.stderr


def test_what_is_kept_is_kept_by_what_it_depends_on():
    q, crown = default().clutch, ((2.0, 0.6, 1e-5),)

    def name(torques=(25.0,), crowns=crown, **changes):
        return model.key((q.model_copy(update=changes), torques, crowns, "slices"))

    others = [
        name(torques=(26.0,)), name(crowns=((2.0, 0.6, 1.1e-5),)), name(mu_s=0.13), name(Q=3e3),
        name(slices=43),
    ]  # fmt: skip
    assert len({name(), *others}) == 6
    # the crown now, the limit of a report and the torque of the file change no engagement
    assert name() == name(K_1=3.0) == name(z_m=0.0) == name(p_lim=1e9) == name(T=30.0)


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
    return _check(one, paper, paper.answers(np.array([crown])), 0, 0, "wanted")


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


@pytest.mark.parametrize("contacts", ["slices", "strips"])
def test_a_crown_whose_ends_carry_fails_though_its_largest_pressure_agrees(paper, contacts):
    """Cells of 18 µm have no more at the end than inside; ever narrower ones have."""
    found = checked(paper, (2.67, 0.7, 9.5e-6), contacts)
    assert abs(found.off(found.judged)) < 0.01 < LIMIT
    assert 0 < found.end < found.peak
    narrow = paper.by_strips(found.crown[None], np.array([found.N]), 0, 1593)[0]
    assert narrow[0] > 1.08 * found.peak
    assert not found.agrees


def test_a_crown_with_free_ends_passes_by_slices_and_strips_alike(paper):
    for contacts in ("slices", "strips"):
        found = checked(paper, (2.6, 0.657, 16e-6), contacts)
        assert found.end == 0
        assert found.agrees
        assert abs(found.off(found.judged)) < 0.01 < LIMIT
        assert abs(found.mid_off) < 0.01
        assert found.coarse == pytest.approx(found.peak, rel=2e-3)


@pytest.mark.parametrize("z_m", [11e-6, 12e-6])
def test_narrow_strips_tell_ends_that_carry_as_the_half_space_does(paper, z_m):
    """The wide strips of the search have pressure at both ends."""
    found = checked(paper, (2.7, 0.7, z_m), "strips")
    assert found.strips[0] > 0
    (carries,) = ends_carry(paper, found.crown[None], np.array([found.N]), 0)
    assert carries == (found.end > 0) == (z_m < 11.5e-6)


def test_a_crown_that_begins_at_the_middle_of_a_straight_profile_cannot_be_unloaded(paper):
    """K_1 of a tenth: A is so small that the end drops at the very end alone, whatever z_m."""
    found = checked(paper, (0.2, 0.7, 5e-6), "strips")
    assert unloading(paper, found) is None


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
