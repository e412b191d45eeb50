"""The command `explain`: finding the row, and what is printed."""

import pytest

from analytic.ring import lame
from tests.verify.ring_file import RING
from verify.app.cli import run
from verify.app.explain import find_row
from verify.core.inputs import InputError

IDS = [
    "ring-a/bore displacement, plane stress",
    "ring-a/bore displacement, plane stress: convergence",
    "ring-a/bore displacement, plane strain",
    "ring-a/bore displacement, plane strain: convergence",
    "ring-a/order of the bore displacement",
]


def test_a_row_is_named_by_its_id_a_part_of_it_or_words():
    for wanted, found in (
        ("Bore Displacement plane STRESS", 0),
        ("stress bore", 0),
        ("bore displacement, plane stress: convergence", 1),
    ):
        assert find_row(wanted, IDS) == IDS[found]


@pytest.mark.parametrize(
    ("wanted", "message"),
    [
        ("plane", "2 rows match 'plane': ring-a/bore displacement, plane stress; "),
        ("bore displacment plane stres", "near are: ring-a/bore displacement, plane str"),
        ("xyz", "no row matches 'xyz'; the cases are ring-a"),
        ("  ", "explain needs a row"),
    ],
)
def test_a_name_of_no_row_or_of_several_is_answered_with_names(wanted, message):
    with pytest.raises(InputError, match=r"^[^\n]*$") as raised:
        find_row(wanted, IDS)
    assert message in str(raised.value)


def test_a_row_is_explained_from_levels_to_verdict(capsys):
    assert run(["explain", "ring-lame/bore displacement, plane stress"]) == 0
    out = capsys.readouterr().out.splitlines()
    labels = [line.split("  ")[1].strip() for line in out[1:]]
    order = ["formula", "FE", "behaviour", "order", "p", "F", "GCI", "u_it", "u_num", "u_ref",
             "u_input", "U", "scale", "d", "test", "detects", "verdict"]  # fmt: skip
    assert [label for label in labels if not label.startswith("h = ")] == order
    assert out[-1].endswith("PASS")


def test_a_parameter_file_is_explained_on_its_own_numbers(tmp_path, capsys):
    path = tmp_path / "ring.toml"
    path.write_text(RING)
    assert run(["explain", "bore", "hoop", "stress,", "plane strain", str(path)]) == 0
    assert "formula     260 MPa" in capsys.readouterr().out  # 2.6 p by hand
    assert run(["explain", "order of the displacement in L2", str(path)]) == 2
    err = capsys.readouterr().err  # orders are of the elements, on the paper's inputs alone
    assert err.startswith(f"freewheel: no row with {path} matches")


def test_a_red_row_is_explained_and_makes_the_exit_status_one(monkeypatch, capsys):
    right = lame.strain_energy
    monkeypatch.setattr(lame, "strain_energy", lambda **k: 1.001 * right(**k))
    assert run(["explain", "ring-lame/strain energy, plane stress"]) == 1
    assert "does not hold" in capsys.readouterr().out
