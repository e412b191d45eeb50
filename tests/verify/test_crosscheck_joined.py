"""Second solvers on what is joined: two rotors by a clutch, hubs by struts, a roller and a race."""

import json
import re
from dataclasses import replace

import pytest

from verify.app.crosscheck import command
from verify.core.results import CrossState
from verify.studies.crosscheck import judged, solvers, store
from verify.studies.crosscheck.calculix import running
from verify.studies.crosscheck.comparisons import races, rotors, rounds, springs, struts
from verify.studies.crosscheck.statement import ROSS

AGREES, OUTSIDE = CrossState.AGREES, CrossState.OUTSIDE
installed = pytest.mark.skipif(
    running.executable() is None, reason="calculix (ccx) is not installed"
)
guests = pytest.mark.skipif(
    bool(solvers.solver(ROSS).missing), reason="ROSS is not installed: make crosscheck"
)


@pytest.fixture(autouse=True)
def any_code(monkeypatch):
    """Decks that are spoiled here are of no file's code."""
    monkeypatch.setattr(store, "code_of", lambda _cross: "")


def states(cross, folder, spoil=None):
    """By quantity, with `spoil` done to the text of the deck."""

    def pose():
        posed = cross.pose()

        def write(where):
            deck = posed.write(where)
            text = deck.read_text("utf-8")
            changed = spoil(text)
            assert changed != text
            deck.write_text(changed, "utf-8")
            return deck

        return replace(posed, write=write)

    asked = cross if spoil is None else replace(cross, pose=pose)
    found = command.compare(asked, solvers.solver(cross.solver), folder)
    lines = judged.judged(cross, found)
    return {q.name: line.state for q, line in zip(cross.quantities, lines, strict=True)}


def half_the_clutch(text):
    question = json.loads(text)
    question["bearings"][-1]["kxx"] /= 2  # links come last, the clutch last of them
    return json.dumps(question)


@guests
def test_two_rotors_are_joined_by_the_clutch(tmp_path):
    """Half of it and nothing agrees; as it is, all does: what is kept is tested."""
    (cross,) = [c for c in rotors.ROTORS if c.id == "rotor-sprag, node 19"]
    assert set(states(cross, tmp_path, half_the_clutch).values()) == {OUTSIDE}


def weaker(text):
    """The law of the struts, its table: 1 % less force."""
    head, table, rest = re.split(r"(?<=NONLINEAR\n\n)((?:\S+,\S+\n)+)", text, maxsplit=1)
    rows = [row.split(",") for row in table.splitlines()]
    return head + "".join(f"{0.99 * float(f):.12e},{u}\n" for f, u in rows) + rest


def no_tilt(text):
    """The turn about y is node 2's second component."""
    return re.sub(r"^2,2,2,\S+$", "2,2,2,0.", text, flags=re.MULTILINE)


@installed
@pytest.mark.parametrize(
    ("spoil", "wanted"),
    [
        (None, AGREES),
        (weaker, OUTSIDE),
        (no_tilt, OUTSIDE),  # which changes what every strut bears
    ],
)
def test_struts_press_by_one_law(spoil, wanted, tmp_path):
    assert set(states(struts.STRUTS[0], tmp_path, spoil).values()) == {wanted}


def softer(text):
    return re.sub(
        r"(\*ELASTIC\n)(\S+),", lambda m: f"{m[1]}{0.9 * float(m[2]):.12e},", text, count=1
    )


@installed
@pytest.mark.parametrize("spoil", [None, softer], ids=["as posed", "a softer roller"])
def test_a_roller_presses_into_its_race(spoil, monkeypatch, tmp_path):
    monkeypatch.setattr(races, "LEVEL", 1)
    found = states(races.RACES[0], tmp_path, spoil)
    # the same approach: half-widths are those of the same overlap, whatever is soft
    assert found[races.LOAD] is (AGREES if spoil is None else OUTSIDE)


@installed
@pytest.mark.parametrize("spoil", [None, softer], ids=["as posed", "softer"])
def test_a_round_ring_takes_the_same_pressure(spoil, monkeypatch, tmp_path):
    monkeypatch.setattr(rounds, "FINE", 1)
    found = states(rounds.ROUNDS[0], tmp_path, spoil)
    assert found["p"] is (AGREES if spoil is None else OUTSIDE)


@installed
def test_near_the_load_a_drift_in_newtons_is_not_resolved(monkeypatch, tmp_path):
    """Calculix takes residuals below a millionth of the unit of force for nothing."""
    (cross,) = [c for c in springs.SPRINGS if c.id == "spring-buckling, drift near P"]
    assert states(cross, tmp_path)["u_y"] is AGREES
    monkeypatch.setattr(springs, "SMALL", 1.0)
    assert states(cross, tmp_path)["u_y"] is OUTSIDE


@pytest.mark.parametrize(("share", "times"), [(0.5, 1.69), (0.9, 6.39)])
def test_a_share_of_the_stiffness_is_several_of_the_drift(share, times):
    """P/u_y du_y/dP by the tangent stiffness of the head: what docs/crosscheck.md tells."""
    import numpy as np

    q = springs.BUCKLING.inputs()
    one = springs.spring(q, q.path | {"tail": "arc"}, q.b, springs.LEVEL)
    pushed = {one.head: (q.P, 0.0, 0.0)}
    state = one.frame("").under_loads(pushed, np.linspace(0.05, share, 18)).last
    S, _ = one.head_stiffness(state)
    u_y = state.u[one.head, 1]
    assert share * q.P * np.linalg.inv(S)[1, 0] / u_y == pytest.approx(times, abs=6e-3)
