"""What is printed of a crown, on an outcome whose every number is written down here."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np

from verify.studies.design_sprag import console
from verify.studies.design_sprag.inputs import default
from verify.studies.design_sprag.known import Known
from verify.studies.design_sprag.outcome import Bound, Outcome
from verify.studies.design_sprag.records import _torque, crown

CHOSEN, SHALLOW, BEYOND = (2.6, 0.65, 14e-6), (2.6, 0.7, 8e-6), (2.6, 0.7222, 8e-6)


def known(*rows):
    """Crowns with pressures [MPa] inside and at the end by strips, and by slices, at 10, 25 N m.

    At 10 N m they are half.
    """
    inside, end, by_slices = (np.array([row[1 + k] for row in rows]) * 1e6 for k in range(3))
    strips = np.column_stack([end, inside, inside, inside, end])
    slices = np.repeat(by_slices[:, None], 3, axis=1)
    return Known(
        np.array([row[0] for row in rows]), np.tile([3e3, 6e3], (len(rows), 1)),
        np.stack([slices / 2, slices], axis=1), (strips / 2, strips),
    )  # fmt: skip


def outcome(*, now_carries=(False, True), now=(2900.0, 2400.0, 2950.0), **wishes):
    """The paper's task at 10 and 25 N m; wishes may change it."""
    task = default()
    task = replace(
        task, torques=(10.0, 25.0),
        wishes=task.wishes.model_copy(update={"t_z": 1e-6, "t_y": 1e-4} | wishes),
    )  # fmt: skip
    # the second of the chosen crown's corners has 1100 MPa at its end, which counts as 3300
    chosen = known((CHOSEN, 2980, 0, 2990), (CHOSEN, 2960, 1100, 2970), (CHOSEN, 3010, 0, 3020))
    every = known(
        (CHOSEN, 2980, 0, 2990), (SHALLOW, 2940, 3600, 2945), (BEYOND, 2930, 3900, 2935)
    )  # fmt: skip
    quality = SimpleNamespace(count=9, mean=0.001, largest=0.01)
    search = SimpleNamespace(
        model=SimpleNamespace(known=every, Q=3407.0), judged=[(quality, quality)],
        single=not (task.wishes.t_z or task.wishes.t_y),
    )  # fmt: skip
    return Outcome(
        task=task, search=search, crown=np.array(CHOSEN), chosen=chosen,
        worst=np.array([1650e6, 3300e6]), best_crowns=np.tile(CHOSEN, (2, 1)),
        best=np.array([1600e6, 3200e6]), now=known(((2.67, 0.7, 9.5e-6), *now)),
        now_carries=now_carries, without=known(((2.67, 0.7, 0.0), 2800, 4000, 2800)),
        predicted=1.0, true=1.0, rounds=2, alone=np.zeros((3, 2)), together=np.zeros((3, 2)),
        bounds=(), checks=(), free_from=None, on_edge=False,
    )  # fmt: skip


def test_the_paper_s_crown_is_one_of_the_ranges_at_the_largest_torque():
    """Not K_2 = 0.7222, which only the tolerances of K_2 = 0.7 reach."""
    (line,) = console.paper_s_way(outcome())
    assert "would at the largest torque have gone to K_1 = 2.6, K_2 = 0.7, z_m = 8 µm" in line
    assert "2945 MPa at 25 N m by 3 slices, but 3600 MPa by 5 strips, at its ends" in line


def test_pressures_within_the_tolerance_are_as_they_are():
    """2960 MPa inside, not three times the end's 1100."""
    assert console.band(outcome(), 1) == "2960 to 3010"
    assert console.band(outcome(), 0) == "1480 to 1505"


def test_ends_that_carry_are_named_though_the_largest_pressure_is_inside():
    light, heavy = console.torque_table(outcome())
    assert light[3] == "1450"
    assert heavy[3] == "2900 (ends carry, 5 strips)"
    assert (light[4], heavy[4]) == ("2000 (ends carry, 5 strips)", "4000 (ends carry, 5 strips)")
    heavy = console.torque_table(outcome(contacts="slices"))[1]
    assert heavy[3] == "2950 (ends carry, 3 slices)"


def test_the_record_has_pressures_as_they_are_in_megapascals():
    one = _torque(with_counts(outcome()), 1)
    assert (one["p_least"], one["p"], one["p_worst"]) == (2960.0, 2980.0, 3010.0)
    assert crown(np.array([2.6, 0.7, 25.000000000000004e-6]))["z_m_um"] == 25.0


def with_counts(one):
    one.search.model.counts = (5, 5)
    return one


def test_a_bound_that_costs_nothing_is_named_without_a_warning():
    one = replace(outcome(), bounds=(Bound(1, 0.73, 0.0004), Bound(2, 27e-6, 0.02)))
    (line,) = console.at_bounds(one)
    assert line.startswith("a wider range of K_2, which is at its edge, gains nothing: 0.73")
    (warning,) = [x for x in console.warnings(one) if "edge" in x]
    assert warning.startswith("z_m is at the edge of its range: 27 µm alone would gain 2 %")
