"""Axes of a sweep from the texts of the command line, and the resulting points."""

import numpy as np
import pytest

from tests.verify.sweep_made import CASE, Plate, chosen
from verify.core.inputs import InputError, Inputs, quantity, table, word
from verify.studies.sweep.axes import axis, changed, names, tolerance
from verify.studies.sweep.plan import grid, sample


class Bearing(Inputs):
    k: float = quantity("1 kN/m", "N/m", "k", "stiffness", gt=0)


class Shaft(Plate):
    q: float | None = quantity(None, "mm", "q", "gap")
    h: float = quantity(0.9, "1", "h", "share", ge=0, le=1)
    kind: str = word("plain", "kind")
    supports: tuple[Bearing, ...] = table((Bearing(), Bearing(k=3e3)), "bearings")


def test_an_axis_is_read_and_has_its_input():
    for text, values, nominal, symbol in (
        ("n=3:12:4", (3, 6, 9, 12), 3, "n"),
        ("a=2:6mm:3", (2e-3, 4e-3, 6e-3), 4e-3, "a"),  # the last one's unit
        ("a=0.1mm:10mm:3:log", (1e-4, 1e-3, 1e-2), 4e-3, "a"),
        ("q=1:2mm:2", (1e-3, 2e-3), None, "q"),
        ("supports[2].k=1:2kN/m:2", (1e3, 2e3), 3e3, "k of supports[2]"),
    ):
        found = axis(Shaft(), text)
        assert found.values == pytest.approx(values, rel=1e-12)
        assert (found.nominal, found.symbol, found.whole) == (nominal, symbol, symbol == "n")
    assert axis(Shaft(), "a=2:6mm:3").in_unit(0.3e-3) == 0.3  # not 0.29999999999999993


def test_what_is_no_axis_and_no_tolerance_is_refused_with_its_option():
    for read, text, message in (
        (axis, "a=1mm:2mm", "write NAME=a:b:n"),
        (axis, "a=1mm:2mm:1", "n must be an integer from 2 to 1000, got '1'"),
        (axis, "a=2mm:2mm:3", "all values must be different"),
        (axis, "a=-1mm:2mm:3:log", "with log, both ends must be positive"),
        (axis, "=1mm:2mm:2", "the name of the input is missing"),
        (axis, "kind=1:2:2", "kind takes a word"),
        (axis, "supports[3].k=1:2kN/m:2", "the file contains no supports[3]"),
        (tolerance, "n=±1", "n is a whole number and cannot have a tolerance"),
        (tolerance, "b=±0mm", "the tolerance must be positive and finite"),
        (tolerance, "b=±1.2.3%", '"1.5 mm", nor a percentage of b, such as "5 %"'),
        (
            tolerance,
            "h=±0.2",
            "the tolerance reaches an invalid value: inputs.h = 1.1: must be at most 1",
        ),
    ):
        option = "--vary" if read is axis else "--tolerance"
        with pytest.raises(InputError, match=rf"^{option} ") as error:
            read(Shaft(), text)
        assert text in str(error.value)
        assert message in str(error.value)
        assert "\n" not in str(error.value)


def test_inputs_are_changed_by_name_in_tables_too():
    of = changed(Shaft(), {"a": 5e-3, "n": 4.0, "supports[2].k": 7.0})
    assert (of.a, of.n, of.b) == (5e-3, 4, 2e-3)
    assert isinstance(of.n, int)
    assert [entry.k for entry in of.supports] == [1e3, 7.0]
    with pytest.raises(InputError, match=r"^inputs\.a = -1 mm"):
        changed(Shaft(), {"a": -1e-3})
    assert names(Shaft()) == ["a", "b", "c", "n", "q", "h", "supports[1].k"]


# Points


def test_a_grid_has_all_combinations_and_a_star_one_input_off_its_middle():
    plan = grid(CASE, "plate", Plate(), chosen(), ["a=1:2mm:2", "n=1:3:3"])
    assert plan.points.tolist() == [[a, n] for a in (1e-3, 2e-3) for n in (1, 2, 3)]
    star = grid(CASE, "plate", Plate(), chosen(), ["a=4:6mm:2", "b=1:3mm:2"], star=True)
    rows = [[4e-3, 2e-3], [6e-3, 2e-3], [4e-3, 1e-3], [4e-3, 3e-3]]
    assert star.points == pytest.approx(np.array(rows))
    with pytest.raises(InputError, match="q: give its value in the file"):
        grid(CASE, "plate", Shaft(), chosen(), ["q=1:2mm:2"], star=True)


def test_a_sample_has_two_matrices_and_the_first_with_columns_of_the_second():
    plan = sample(CASE, "plate", Plate(), chosen(), "sobol:16", ["a=±1mm", "b=±5%", "c=+/-100µm"])
    assert [one.off for one in plan.tolerances] == pytest.approx([1e-3, 1e-4, 1e-4], rel=1e-12)
    a, b, *mixed = plan.points.reshape(5, 16, 3)
    for k, one in enumerate(mixed):
        assert (one[:, k] == b[:, k]).all()
        rest = [j for j in range(3) if j != k]
        assert (one[:, rest] == a[:, rest]).all()
    assert (a != b).all()
    for count, tolerances, message in (
        ("sobol:12", ["a=±1mm"], "N must be a power of two from 8"),
        ("sobol", ["a=±1mm"], "--sample must be sobol:N"),
        ("sobol:8", ["a=±1mm", "a=±2mm"], "a must be given only once"),
    ):
        with pytest.raises(InputError, match=message):
            sample(CASE, "plate", Plate(), chosen(), count, tolerances)
