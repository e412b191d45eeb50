"""Which assumed inputs change a value of the formulas, and by how much."""

import math
from pathlib import Path

import pytest

from verify.answers.assumed.influence import UNCHANGED, influence
from verify.answers.assumed.registry import ASSUMPTIONS
from verify.answers.parameter_file import read
from verify.cases.registry import find

PARTS = Path(__file__).parent / "parts"


def studied(name, key):
    file = read(PARTS / f"{name}.toml")
    found = influence(file.case, file.inputs, file.assumed, key)
    return {one.assumed.name: one for one in found}, found


def test_the_stiffness_of_a_spring_follows_its_modulus():
    named, found = studied("accordion-spring-20", "k1")
    assert found[0].assumed.name == "E"
    assert named["E"].at_low == pytest.approx(200 / 206 - 1)
    assert named["E"].at_high == pytest.approx(212 / 206 - 1)
    assert (named["E"].low, named["E"].high) == pytest.approx((200, 212))
    assert not named["nu"].matters
    assert [one.largest for one in found] == sorted((one.largest for one in found), reverse=True)
    # the width factor of a plate follows from nu: with another nu the given one could not be
    named, _ = studied("accordion-curve-20", "k1")
    assert named["nu"].note == ""
    assert named["nu"].at_low < 0


def test_a_variation_without_a_solution_is_reported_first():
    named, found = studied("drawn-cup-20", "alpha")
    assert named["X"].at_high is None
    assert named["X"].note == "no solution"
    assert found[0] is named["X"]
    assert math.isinf(found[0].largest)
    # only numbers that formulas use are varied
    assert set(studied("fan-rotor-inch", "frequency_1")[0]) == {"speed", "margin"}


def test_what_is_left_to_the_motion_in_time_changes_no_formula():
    file = read(PARTS / "sprag-clutch-55.toml")
    given = {n: getattr(file.inputs, n) for n in type(file.inputs).model_fields}
    names = [one.name for one in ASSUMPTIONS["sprag-clutch"] if one.dynamic]
    other = type(file.inputs)(**given | {name: given[name] * 0.9 for name in names})
    found = find("sprag-clutch").analytic(other)
    for key, value in file.values.items():
        assert found[key] == pytest.approx(value, rel=UNCHANGED, abs=0), key
