"""The pitch of a freewheel transmits in calculix what it does here.

What differs is the penalty, for calculix presses surfaces by their overlap: a tenth of the
stiffness takes ten times as much off the forces. That its circles are the parabolas of the cells'
sides and its quadrilaterals lack the middle node counts less than the mesh does.
"""

import pytest

from benchmarks import sector
from benchmarks.calculix_freewheel import Deck, Settings
from verify.studies.crosscheck.calculix.running import executable

CELLS = 4
SOFT, STIFF = 5.0, 50.0  # E/a
FORCES = ("T", "N_i", "N_o", "F_i", "F_o")
MESH = 1e-3  # forces on this mesh err by up to 6.4e-4 here, against one of 18 cells

pytestmark = pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """What is judged, here and in calculix with a soft and with a stiff contact."""
    problem = sector.posed(sector.pitch(CELLS))
    solution = sector.turned(problem)
    deck = Deck(problem, solution)

    def asked(slope):
        path = tmp_path_factory.mktemp("pitch") / "freewheel.inp"
        how = Settings(slope=slope)
        deck.write(path, how)
        return deck.run(path, how, limit=300.0).found

    return sector.found(solution), asked(SOFT), asked(STIFF)


@pytest.mark.slow("a pitch here and twice in calculix, for all tests of this file")
def test_torque_and_forces_are_those_of_calculix(both):
    here, _, stiff = both
    apart = sector.errors(stiff, here)
    assert [apart[name] for name in FORCES] == pytest.approx([0] * len(FORCES), abs=0.01)
    assert apart["centre"] < 1e-3


@pytest.mark.parametrize("name", FORCES)
def test_what_differs_from_calculix_falls_as_its_contact_stiffens(both, name):
    here, *there = both
    soft, stiff = (sector.errors(other, here)[name] for other in there)
    assert stiff == pytest.approx(soft * SOFT / STIFF, abs=MESH)
    assert abs(soft) > 5 * abs(stiff)


@pytest.mark.parametrize("side", ["i", "o"])
def test_friction_over_pressure_does_not_feel_the_penalty(both, side):
    here, soft, stiff = (one[f"F_{side}"] / one[f"N_{side}"] for one in both)
    assert [soft, stiff] == pytest.approx([here, here], rel=MESH)
