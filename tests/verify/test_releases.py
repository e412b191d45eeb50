"""Changes since a release are reported, and a larger tolerance needs a reason."""

import json
import math
from dataclasses import replace

import pytest

from verify.app import release as making
from verify.app.cli import run
from verify.app.report import make_report
from verify.app.up_to_date import STAMP
from verify.audit.releases import changes as since
from verify.audit.releases import reasons
from verify.audit.releases import store as kept
from verify.audit.releases.compare import drift
from verify.audit.releases.reasons import Reason
from verify.audit.releases.store import Release, load, newest, store
from verify.cases.ring.lame.case import LAME
from verify.core.inputs import InputError
from verify.core.results import CaseResult, Kind, Partner, Row, Status

ROW = Row(
    case="c", quantity="q", symbol="x", unit="mm", kind=Kind.IDENTITY, status=Status.PASS,
    analytic=2.0, fem=2.001, difference=0.001, scale=2.0, demand=0.01, u_num=0.001, u_ref=0.0,
    tolerance=0.002, detects=0.0015,
)  # fmt: skip
APPROXIMATE = replace(ROW, kind=Kind.APPROXIMATION, interval=(-0.01, 0.03))
BALANCE = replace(
    ROW, kind=Kind.EXACT, analytic=None, fem=1e-13, u_num=None, u_ref=None, difference=1e-13,
    tolerance=2e-9,
)  # fmt: skip
DEVIATION = replace(  # a size of 1e-4, 1e-3 accepted of it, its U 2e-4
    ROW, unit="1", analytic=0.0, fem=1e-4, difference=-1e-4, scale=1.0, u_num=1e-4, tolerance=8e-4,
    detects=9e-4, interval_source="what a balance leaves",
)  # fmt: skip
FACT = Row(
    case="c", quantity="f", symbol="x", unit="1", kind=Kind.FACT, status=Status.PASS,
    difference=0.4, tolerance=0.01, demand=0.01, reason="held: off by +0.07%, 0.2% accepted",
)  # fmt: skip
BARE = replace(ROW, status=Status.SHOWN, fem=2.0, u_num=None, tolerance=None, detects=None)
PARTNER = replace(ROW, fem=None, partner=Partner(by="strips", value=2.0))
COMPUTED = replace(APPROXIMATE, interval=(-0.00827639401, 0.0249590585))  # a tenth: 0.00166
# its tenth is 1e-4, the numerical error of both runs √2 · 0.001
NARROW = replace(COMPUTED, interval=(-0.00100123456, 0.00100234567))
SHARP = replace(ROW, detects=1e-4)


def result(*rows, case="c"):
    return CaseResult(
        id=case, title="", paper="", place="", lead="", inputs=(), equations=(), assumptions=(),
        readings=(), rows=rows,
    )  # fmt: skip


def release(*rows):
    return Release(
        version="0.1.0", date="2026-01-01", commit="abc",
        rows={row.id: kept.kept(row) for row in rows},
    )  # fmt: skip


def found(before, change, why=()):
    """What is reported of one row's change."""
    return drift(release(before), [result(replace(before, **change))], why)


def aspects(changed):
    return [(c.aspect, c.loosened) for c in changed.changes]


FORMULA, FE, MARGIN = ("formula", False), ("finite elements", False), ("margin", False)
MOVED = [
    # beyond twice the root of both squares: 2 √2 · 0.001 = 0.00283
    (ROW, {"fem": 2.001 + 0.0028}, []),
    (ROW, {"fem": 2.001 + 0.0029}, [FE]),
    # without error and band: beyond round-off
    (BARE, {"analytic": 2 + 1.8e-10}, []),
    (BARE, {"analytic": 2 + 2.2e-10}, [FORMULA]),
    # near zero: beyond what the balance allows
    (BALANCE, {"fem": 4e-9}, [FE]),
    # beyond a tenth of half of the interval, 0.004, and the numerical error, 0.00283
    (APPROXIMATE, {"analytic": 2.0039}, []),
    (APPROXIMATE, {"analytic": 2.0041}, [FORMULA]),
    # a fact: beyond a tenth of the margin, 0.04
    (FACT, {"difference": 0.439}, []),
    (FACT, {"difference": 0.441}, [MARGIN]),
    (PARTNER, {"partner": Partner(by="strips", value=2.1)}, [FE]),
    (ROW, {"fem": math.nan}, [FE]),
    (replace(ROW, fem=math.nan), {"fem": math.nan}, []),
    (ROW, {"kind": Kind.TREND}, [("kind", False)]),
    (ROW, {"scale": 1.79}, [("scale", False)]),
    # the order of convergence may scatter
    (replace(ROW, quantity="q: convergence", kind=Kind.FACT, u_num=None),
     {"fem": 3.0, "difference": 9.0}, []),
    # demands of the same printed digits
    (replace(ROW, demand=0.0239411171), {"demand": 0.0239411999}, []),
    # what a row no longer detects
    (ROW, {"detects": 0.0029}, []),
    (ROW, {"detects": 0.0031, "u_num": 0.0021}, [("detects", False)]),
    (SHARP, {"detects": 1.09e-3}, []),  # a tenth of the demand is 1e-3
    (SHARP, {"detects": 1.11e-3}, [("detects", False)]),
    (ROW, {"u_num": 0.0021}, [("uncertainty", False)]),
    # computed bands may move within their error and a tenth
    (COMPUTED, {"interval": (-0.00827639401, 0.0265590585)}, []),
    (NARROW, {"interval": (-0.00240123456, -0.00039765433)}, []),
    (replace(ROW, u_num=1e-9, u_ref=1.2587554e-4), {"u_ref": 1.09 * 1.2587554e-4}, []),
    # an accepted figure is the same for any uncertainty
    (DEVIATION, {"u_num": 5e-5, "tolerance": 9e-4, "detects": 1e-3}, []),
    (FACT, {"reason": "held: off by +0.07%, 0.2% accepted, 1% asked"}, [("acceptance", False)]),
]  # fmt: skip


@pytest.mark.parametrize(("row", "change", "reported"), MOVED)
def test_a_change_is_reported_beyond_its_error_or_a_tenth_of_its_band(row, change, reported):
    changed = found(row, change)
    assert aspects(changed) == reported
    assert not changed.unexplained
    if not reported:
        assert since.lines(changed) == ["since 0.1.0: 1 rows compared, no changes"]


LOOSENED = [
    (ROW, {"demand": 0.02}, "demand", "1 % -> 2 %"),
    (ROW, {"demand": None}, "demand", "1 % -> none"),
    (replace(ROW, demand=0.02), {"demand": 0.0200006}, "demand", "2 % -> 2.0001 %"),
    (replace(ROW, u_ref=0.001), {"u_ref": 0.00101}, "reference", "0.05 % -> 0.0505 %"),
    (BALANCE, {"tolerance": 2.02e-9}, "bound", "1e-07 % -> 1.01e-07 %"),
    (COMPUTED, {"interval": (-0.00828, 0.0249590585)}, "interval",
     "-0.827639 to +2.49591 % -> -0.828 to +2.49591 %"),  # a literal instead
    (COMPUTED, {"interval": (-0.00827639401, 0.0266590585)}, "interval",
     "-0.827639 to +2.49591 % -> -0.827639 to +2.66591 %"),
    # wider on one side, although narrower on the other
    (APPROXIMATE, {"interval": (-0.011, 0.0)}, "interval", "-1 to +3 % -> -1.1 to +0 %"),
    (APPROXIMATE, {"interval": None}, "interval", "-1 to +3 % -> none"),
    (FACT, {"reason": "held: off by +0.07%, 0.3% accepted"}, "acceptance",
     "0.2 % accepted -> 0.3 % accepted"),
    (FACT, {"reason": "held: off by +0.07%"}, "acceptance", "0.2 % accepted -> none"),
    (replace(FACT, reason="held: by 7.9% and more, 2% asked"),
     {"reason": "held: by 7.9% and more, 1% asked"}, "acceptance", "2 % asked -> 1 % asked"),
    # as wide as before beside its U, which is less now
    (DEVIATION, {"tolerance": 1e-3, "u_num": 5e-5, "detects": 1e-3}, "acceptance",
     "0.1 % -> 0.11 %"),
    (ROW, {"scale": 2.21}, "scale", "2 mm -> 2.21 mm"),
    (ROW, {"status": Status.SHOWN}, "status", "PASS -> SHOWN"),
]  # fmt: skip


def reason(**more):
    return Reason(**{"rows": "c/*", "aspect": "demand", "what": "w", "since": "0.1.0",
                     "why": "a reason of some length"} | more)  # fmt: skip


@pytest.mark.parametrize(("row", "change", "aspect", "words"), LOOSENED)
def test_a_loosened_requirement_fails_without_a_reason(row, change, aspect, words):
    changed = found(row, change)
    assert [c.aspect for c in changed.unexplained] == [aspect]
    assert f"{since.WITHOUT}: {row.id}: {aspect} {words}" in since.lines(changed)
    explained = found(row, change, [reason(aspect=aspect)])
    assert not explained.unexplained
    assert not explained.unused
    assert f"  {row.id}: {aspect} {words}; a reason of some length" in since.lines(explained)


def test_a_reason_for_something_else_explains_nothing_and_is_named():
    for change in ({"rows": "d/*"}, {"aspect": "interval"}, {"since": "0.0.9"}):
        changed = found(ROW, {"demand": 0.02}, [reason(**change)])
        assert changed.unexplained
        # of rows that were compared, since the release
        assert changed.unused == (("c/*: interval: w",) if "aspect" in change else ())


def test_a_tightened_requirement_is_counted():
    changed = found(APPROXIMATE, {"interval": (-0.01, 0.02)})
    assert (changed.tightened, changed.changes) == (1, ())
    assert since.summary(changed) == "1 rows compared, 1 tightened"
    assert [one.row for one in changed.tighter] == [ROW.id]


# Names


def test_a_row_with_a_new_name_and_the_old_numbers_is_the_same_row():
    for change, reported in (
        ({"demand": 0.02}, [("name", False), ("demand", True)]),
        ({"fem": ROW.fem * (1 + 1e-7), "u_num": 0.0012}, [("name", False)]),  # another processor
        ({"fem": ROW.fem * (1 + 1e-5)}, [("gone", True), ("new", False)]),
        ({"quantity": "p within 2 % of the best"}, [("name", True)]),  # another figure in it
    ):
        assert aspects(found(ROW, {"quantity": "p"} | change)) == reported


def test_a_row_that_is_gone_needs_a_reason_and_new_ones_are_counted():
    new = [replace(ROW, quantity=name, analytic=value) for name, value in (("a", 5.0), ("b", 6.0))]
    changed = drift(release(ROW, FACT), [result(FACT, *new)], ())
    assert [(c.row, c.aspect, c.loosened, c.now) for c in changed.changes] == [
        ("c/q", "gone", True, "none"), ("c", "new", False, "2 rows"),
    ]  # fmt: skip
    shown = replace(ROW, status=Status.SHOWN)
    assert not drift(release(shown), [result(FACT)], ()).unexplained  # it judged nothing
    # cases that were not run and rows that were skipped are not compared
    skipped = replace(ROW, status=Status.SKIP, analytic=None, fem=None, demand=None)
    changed = drift(release(ROW, FACT, replace(ROW, case="d")), [result(skipped)], ())
    assert (changed.compared, changed.changes) == (0, ())


# Files


def test_a_release_is_read_as_it_was_written(tmp_path, of_paper):
    rows = of_paper(LAME).rows
    path = store(rows, "0.2.0", "abc", tmp_path)
    assert path.read_bytes() == store(rows, "0.2.0", "abc", tmp_path).read_bytes()
    again = load(path)
    assert again.rows == {row.id: kept.kept(row) for row in rows}
    assert drift(again, [of_paper(LAME)], ()).changes == ()
    store([ROW], "0.10.0", "abc", tmp_path)
    assert newest(tmp_path).version == "0.10.0"
    path.write_bytes(b"\x1f\x8b\x08\x00torn")
    with pytest.raises(InputError, match="is not a release file"):
        load(path)


def test_a_wrong_reason_is_named_in_one_line(tmp_path):
    path = tmp_path / "changes.toml"
    entry = '[[changes]]\nrows = "c/q"\naspect = "{}"\nwhat = "w"\nsince = "0.1.0"\nwhy = "so"'
    path.write_text(entry.format("mood"), "utf-8")
    with pytest.raises(InputError, match=r"changes.1..(aspect|why: String should ha)") as error:
        reasons.read(path)
    assert "\n" not in str(error.value)


@pytest.fixture
def loosened(tmp_path, monkeypatch, of_paper):
    """A release of ring-lame in a separate folder, one demand of which was half as large."""
    monkeypatch.setattr(kept, "FOLDER", tmp_path)
    monkeypatch.setattr(reasons, "FILE", tmp_path / "changes.toml")
    first, *rest = of_paper(LAME).rows
    store([replace(first, demand=first.demand / 2), *rest], "0.1.0", "abc", tmp_path)
    return first.id


@pytest.mark.slow("a run with its report")
def test_a_run_with_a_loosened_demand_ends_with_one(loosened, tmp_path, capsys):
    out = tmp_path / "out"
    command = ["verify", "ring-lame", "--jobs", "1", "--out", str(out)]
    assert run(command) == 1
    assert f"{since.WITHOUT}: {loosened}: demand" in capsys.readouterr().out
    record = json.loads((out / "results.json").read_text("utf-8"))["drift"]
    assert (record["unexplained"], record["changes"][0]["row"]) == (1, loosened)
    (out / STAMP).unlink()  # the file of reasons is not that of the project here
    reasons.FILE.write_text("[[", "utf-8")
    assert run(command) == 2
    assert "changes.toml: cannot be read" in capsys.readouterr().err


def test_a_release_refuses_a_loosened_demand_without_a_reason(loosened, of_paper):
    with pytest.raises(InputError, match=f"{since.WITHOUT}: {loosened}"):
        making.refuse_red(make_report([of_paper(LAME)], [LAME], 1.0))
