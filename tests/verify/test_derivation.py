"""Rows judged again from their data: equal numbers, verdicts and words."""

import math
from dataclasses import replace
from itertools import product

import pytest

from analytic.ring import lame
from tests.verify.ring_file import RING
from tests.verify.rows_again import assert_the_same
from tests.verify.test_checks import approximation, identity, limit, rows_of
from verify.app.cli import run
from verify.app.explain import find_row
from verify.core.inputs import InputError
from verify.core.results import Status
from verify.judging.checks import Fact
from verify.judging.explain.steps import derive, steps
from verify.judging.profile_checks import Coefficient

MONOTONE = [5.032e-6, 5.008e-6, 5.002e-6]
FAR = [5.1e-6, 5.01e-6, 5.001e-6]
SERIES = {
    "monotone": MONOTONE,
    "far from its order": FAR,
    "oscillating": [5.01e-6, 4.99e-6, 5.005e-6],
    "slow": [5.03e-6, 5.02e-6, 5.012e-6],
    "diverging": [5.0e-6, 5.01e-6, 5.04e-6],
    "round-off": [5e-6, 5e-6, 5e-6],
    "short": [5.01e-6, 5.0e-6],
    "not a number": [5.1e-6, 5.01e-6, math.nan],
}
VALUES = {"g": 5e-6, "k": 5e-6}


@pytest.mark.parametrize("name", SERIES)
def test_series_of_every_behaviour_are_judged_equally_again(name):
    series = SERIES[name]
    claims = (identity(), identity(formal=None), approximation(None),
              approximation(lambda _q, _v: (-0.01, 0.01)))  # fmt: skip
    for claim, u_it in product(claims, (0.0, 1e-9)):
        for row in rows_of(claim, series, analytic=VALUES, u_it=u_it):
            assert_the_same(row)
            assert steps(row)


def test_fits_and_facts_are_judged_equally_again_and_state_their_numbers():
    eps = [0.01, 0.02, 0.05, 0.1]
    square = limit(lambda _c: (eps, [3 * e**2 for e in eps], [1e-6] * 4), 2.0)
    curved = Coefficient(
        name="coefficient", symbol="c", unit="1", theory=3.0,
        points=lambda _c: (eps, [3 * e**2 - 2 * e**4 for e in eps], [1e-6] * 4),
    )  # fmt: skip
    held = Fact(name="fact", symbol="m", unit="µm", margin=lambda _c: (2e-6, 1e-6))
    undecided = replace(held, margin=lambda _c: (1e-7, 1e-6))
    for claim, status, label, words in (
        (square, Status.PASS, "fit", "q = 2.0000"),
        (curved, Status.PASS, "fit", "c = +3.00000"),
        (replace(curved, theory=3.1), Status.FAIL, "fit", "c = +3.00000"),
        (held, Status.PASS, "test", "holds"),
        (undecided, Status.FAIL, "test", "does not hold"),
    ):
        (row,) = rows_of(claim)
        assert row.status is status
        assert_the_same(row)
        assert words in dict(steps(row))[label]


def test_the_index_has_its_numbers_put_in():
    """By hand: p = log2(24/6) = 2, GCI = 1.25 0.006/(4 - 1) = 0.0025 µm, U = 2 GCI/2."""
    row, _ = rows_of(identity(), MONOTONE, analytic=VALUES)
    printed = dict(steps(row))
    assert printed["GCI"] == "F |v1 − v2|/(r^p − 1) = 1.25 × 0.006/(2^2.0000 − 1) = 0.0025 µm"
    assert printed["U"].endswith("= 2 √(0.00125² + 0² + 0²) = 0.0025 µm")
    assert printed["test"] == "|d| ≤ U, that is 0.002 ≤ 0.0025: holds"
    assert printed["detects"].startswith("(U + |d|)/scale = (0.0025 + 0.002)/5 = 0.090 %")
    # p = log2(0.09/0.009) = 3.32 against 2 takes the larger factor: 3 0.009/(2^2 - 1) = 0.009 µm
    row, _ = rows_of(identity(), FAR, analytic=VALUES)
    printed = dict(steps(row))
    assert printed["F"] == "3: observed and theory differ by 1.3, beyond 0.5"
    # a row without a result has its verdict alone
    skipped, _ = identity().skipped("ring-made-up", "quick")
    row = replace(skipped, status=Status.FAIL, reason="level 2: MemoryError")
    assert derive(row).verdict.status is Status.FAIL
    assert steps(row) == (("verdict", "FAIL: level 2: MemoryError"),)


# The command `explain`

IDS = [
    "ring-a/bore displacement, plane stress",
    "ring-a/bore displacement, plane stress: convergence",
    "ring-a/bore displacement, plane strain",
    "ring-a/bore displacement, plane strain: convergence",
    "ring-a/order of the bore displacement",
]


def test_a_row_is_named_by_its_id_a_part_of_it_or_words():
    for name, found in (
        ("Bore Displacement plane STRESS", 0),
        ("stress bore", 0),
        ("bore displacement, plane stress: convergence", 1),
        ("ring-a/bore displacement, plane stress (u_r(r_i), mm)", 0),  # as on a page
    ):
        assert find_row(name, IDS) == IDS[found]


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("plane", "2 rows match 'plane'; give one of these names: "
         "ring-a/bore displacement, plane stress; "),
        ("bore displacment plane stres", "similar rows: ring-a/bore displacement, plane str"),
        ("xyz", "no row matches 'xyz'; the cases are ring-a"),
    ],
)  # fmt: skip
def test_a_name_of_no_row_or_of_several_is_answered_with_names(name, message):
    with pytest.raises(InputError, match=rf"^[^\n]*{message}[^\n]*$"):
        find_row(name, IDS)


def test_a_parameter_file_is_explained_with_its_numbers(tmp_path, capsys):
    path = tmp_path / "ring.toml"
    path.write_text(RING)
    assert run(["explain", "bore", "hoop", "stress,", "plane strain", str(path)]) == 0
    out = capsys.readouterr().out
    assert "formula     260 MPa" in out  # 2.6 p by hand
    labels = [line.split("  ")[1].strip() for line in out.splitlines()[1:]]
    order = ["formula", "FE", "behaviour", "order", "p", "F", "GCI", "u_it", "u_num", "u_ref",
             "u_input", "U", "scale", "d", "test", "detects", "verdict"]  # fmt: skip
    assert [label for label in labels if not label.startswith("h = ")] == order
    assert run(["explain", "displacement in the L2 norm", str(path)]) == 2
    err = capsys.readouterr().err  # orders are of the elements, on the paper's inputs alone
    assert err.startswith(f"freewheel: no row with {path} matches")


def test_a_failed_row_is_explained_and_makes_the_exit_status_one(monkeypatch, capsys):
    right = lame.strain_energy
    monkeypatch.setattr(lame, "strain_energy", lambda **k: 1.001 * right(**k))
    assert run(["explain", "ring-lame/strain energy, plane stress"]) == 1
    assert "does not hold" in capsys.readouterr().out
