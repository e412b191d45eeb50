"""One pitch of a freewheel transmits the same torque in calculix as in this project.

What differs is the penalty, for calculix presses surfaces by their overlap: a tenth of the
stiffness takes ten times as much off the forces. That its circles are the parabolas of the cells'
sides and its quadrilaterals lack the middle node counts less than the mesh does.
"""

import pytest

from benchmarks import sector
from benchmarks.calculix_freewheel import Deck, Settings
from verify.studies.crosscheck.calculix.running import executable

SOFT, STIFF = 5.0, 50.0  # E/a
FORCES = ("T", "N_i", "N_o", "F_i", "F_o")
MESH = 1e-3  # forces on this mesh err by up to 6.4e-4 here, against one of 18 cells


@pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")
@pytest.mark.slow("a pitch here and twice in calculix")
def test_what_differs_from_calculix_falls_as_its_contact_stiffens(tmp_path):
    problem = sector.posed(sector.pitch(4))
    solution = sector.turned(problem)
    deck, here, there = Deck(problem, solution), sector.found(solution), []
    for slope in (SOFT, STIFF):
        path, how = tmp_path / f"freewheel-{slope:g}.inp", Settings(slope=slope)
        deck.write(path, how)
        there.append(deck.run(path, how, limit=300.0).found)
    soft, stiff = (sector.errors(one, here) for one in there)
    for name in FORCES:
        assert stiff[name] == pytest.approx(0, abs=0.01)
        assert stiff[name] == pytest.approx(soft[name] * SOFT / STIFF, abs=MESH)
        assert abs(soft[name]) > 5 * abs(stiff[name])
    assert stiff["centre"] < 1e-3
    for side in "io":  # friction over pressure does not feel the penalty
        ratios = [one[f"F_{side}"] / one[f"N_{side}"] for one in (here, *there)]
        assert ratios == pytest.approx([ratios[0]] * 3, rel=MESH)
