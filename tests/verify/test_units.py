"""Strings with units: what a user writes, what SI makes of it, and what is refused."""

import math
import re
import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verify.cases.registry import CASES
from verify.core import units
from verify.core.inputs import meta

fixed = settings(deadline=None, derandomize=True)

# Definitions: SI brochure; inch 25.4 mm and pound 0.45359237 kg by the 1959 agreement, standard
# gravity 9.80665 m/s², so lbf = 4.4482216152605 N and psi = lbf/in².
PSI = 4.4482216152605 / 0.0254**2


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("11.6 mm", "mm", 0.0116),
        ("11.6mm", "mm", 0.0116),
        ("  11.6   mm  ", "mm", 0.0116),
        ("1.16 cm", "mm", 0.0116),
        ("0.0116 m", "mm", 0.0116),
        ("11600 µm", "mm", 0.0116),  # micro sign, U+00B5
        ("11600 μm", "mm", 0.0116),  # Greek mu, U+03BC
        ("11600 um", "mm", 0.0116),
        ("1 in", "mm", 0.0254),
        ("1 metre", "mm", 1.0),
        ("-3 mm", "mm", -0.003),
        ("+3 mm", "mm", 0.003),
        (".5 mm", "mm", 0.0005),
        ("5. mm", "mm", 0.005),
        ("5e-1 mm", "mm", 0.0005),
        ("5E+1mm", "mm", 0.05),
        ("0 mm", "mm", 0.0),
        ("206 GPa", "MPa", 206e9),
        ("206e3 N/mm^2", "MPa", 206e9),
        ("206e3 N/mm**2", "MPa", 206e9),
        ("206e3 N/mm²", "MPa", 206e9),
        ("7850 kg/m³", "kg/m^3", 7850.0),
        ("206e3 N mm^-2", "MPa", 206e9),
        ("1 bar", "MPa", 1e5),
        ("1 psi", "MPa", PSI),
        ("1 kg/m/s^2", "MPa", 1.0),
        ("1 kN", "N", 1e3),
        ("1 lbf", "N", 4.4482216152605),
        ("1 kg m/s^2", "N", 1.0),
        ("0.601 N/mm", "N/mm", 601.0),
        ("0.601 kN/m", "N/mm", 601.0),
        ("40 N m", "N m", 40.0),
        ("40 N·m", "N m", 40.0),
        ("40 N*m", "N m", 40.0),
        ("40 m N", "N m", 40.0),
        ("40000 N mm", "N m", 40.0),
        ("40 J", "N m", 40.0),
        ("1 kg m^2 / s^2 / rad", "N m/rad", 1.0),
        ("7.85 g/cm^3", "kg/m^3", 7850.0),
        ("7850 kg/m^3", "kg/m^3", 7850.0),
        ("2 kg", "kg", 2.0),
        ("2000 g", "kg", 2.0),
        ("1 lb", "kg", 0.45359237),
        ("16 oz", "kg", 0.45359237),
        ("1 slug", "kg", 4.4482216152605 / 0.3048),
        ("1 lb in^2", "kg m^2", 0.45359237 * 0.0254**2),
        ("1 lb ft^2", "kg m^2", 0.45359237 * 0.3048**2),
        ("1 lbf in/rad", "N m/rad", 4.4482216152605 * 0.0254),
        ("3 kg m^2", "kg m^2", 3.0),
        ("4 kg^2", "kg^2", 4.0),
        ("5 m/kg", "m/kg", 5.0),
        ("180 deg", "deg", math.pi),
        ("180°", "deg", math.pi),
        ("1.5 rad", "deg", 1.5),
        ("57.29577951308232 deg", "rad", 1.0),
        ("2 min", "s", 120.0),
        ("20 ms", "s", 0.02),
        ("50 Hz", "Hz", 50.0),
        ("1 kW", "W", 1e3),
        ("0.3", "1", 0.3),
        ("-1e-3", "1", -0.001),
        ("30 %", "1", 0.3),
        ("30%", "1", 0.3),
    ],
)
def test_a_quantity_is_read_in_si(text, unit, value):
    assert units.parse(text, unit) == pytest.approx(value, rel=4e-16)  # two roundings


@pytest.mark.parametrize(
    ("unit", "factor"),
    [
        ("1", 1.0),
        ("%", 0.01),
        ("mm", 1e-3),
        ("µm", 1e-6),
        ("mm^2", 1e-6),
        ("MPa^2", 1e12),
        ("N/mm", 1e3),
        ("N m", 1.0),
        ("N m/rad", 1.0),
        ("N m s/rad", 1.0),
        ("J/m", 1.0),
        ("kg m^2", 1.0),
        ("g", 1e-3),
        ("g^2", 1e-6),
        ("1/mm", 1e3),
        ("1/s", 1.0),
        ("rad/s", 1.0),
        ("r/min", 2 * math.pi / 60),  # a turn is 2 pi rad
    ],
)
def test_a_unit_is_so_many_si_units(unit, factor):
    assert units.factor(unit) == pytest.approx(factor, rel=4e-16)


@pytest.mark.parametrize("unit", ["1/mm", "1/s"])
def test_a_reciprocal_is_read_as_it_is_printed(unit):
    assert units.parse(f"0.012 {unit}", unit) == pytest.approx(0.012 * units.factor(unit))


@pytest.mark.parametrize(
    ("text", "unit", "message"),
    [
        pytest.param("60", "mm", "has no unit: needs a length", id="no unit"),
        pytest.param("60", "deg", "has no unit: needs an angle", id="a number is no angle"),
        pytest.param("1.5 rad", "1", "is not a number", id="an angle is no number"),
        pytest.param("60 N", "mm", "is not a length", id="a force for a length"),
        pytest.param("60 mm^2", "mm", "is not a length", id="an area for a length"),
        pytest.param("60 N/mm", "N", "is not a force", id="a stiffness for a force"),
        pytest.param("60 N/mm", "MPa", "is not a pressure", id="a stiffness for a stress"),
        pytest.param("60 kg", "N", "is not a force", id="a mass for a force"),
        pytest.param("60 mm", "1", "is not a number", id="a length for a number"),
        pytest.param("0.3 N", "kg/m^3", "is not a density", id="a force for a density"),
        pytest.param("1 N m/rad", "N m", "is not a torque", id="a turning stiffness"),
        pytest.param("60 mpa", "MPa", "is not a known unit", id="no such case"),
        pytest.param("60 furlong", "mm", "is not a known unit", id="unknown"),
        pytest.param("60 k", "mm", "is not a known unit", id="a prefix alone"),
        pytest.param("60 None", "mm", "is not a known unit", id="a word of Python"),
        pytest.param("60 lambda", "mm", "is not a known unit", id="a keyword of Python"),
        pytest.param("60 nan", "1", "is not a known unit", id="NaN as a unit"),
        pytest.param("60 mm^2^2", "mm", "is not a unit", id="power of a power"),
        pytest.param("60 mm/", "mm", "is not a unit", id="nothing below the line"),
        pytest.param("60 mm**", "mm", "is not a unit", id="no power"),
        pytest.param("60 mm^99", "mm", "is not a unit", id="two digits of power"),
        pytest.param("60 mm;", "mm", "is not a unit", id="semicolon"),
        pytest.param("60 __import__('os')", "mm", "is not", id="code"),
        pytest.param("60 (mm)", "mm", "is not a length", id="brackets"),
        pytest.param("sixty mm", "mm", "is not a length", id="a word"),
        pytest.param("mm", "mm", "is not a length", id="a unit alone"),
        pytest.param("", "mm", "is not a length", id="nothing"),
        pytest.param("   ", "1", "is not a number", id="blanks"),
        pytest.param("60,5 mm", "mm", "decimals follow a point", id="decimal comma"),
        pytest.param("1 000 mm", "mm", "is not a length", id="blank in the number"),
        pytest.param("1_000 mm", "mm", "is not a", id="underscore in the number"),
        pytest.param("60 ± 1 mm", "mm", "is not a length", id="with a tolerance"),
        pytest.param("60 mm 5", "mm", "is not a", id="something behind"),
        pytest.param("--60 mm", "mm", "is not a length", id="two signs"),
        pytest.param("0x3c mm", "mm", "is not a", id="hexadecimal"),
        pytest.param("nan mm", "mm", "is not finite", id="NaN"),
        pytest.param("-inf mm", "mm", "is not finite", id="infinite"),
        pytest.param("nano mm", "mm", "is not a length", id="a word that begins with nan"),
        pytest.param("1e999 mm", "mm", "is not finite", id="beyond floats"),
        pytest.param("-1e999", "1", "is not finite", id="a number beyond floats"),
        pytest.param("1e308 km", "mm", "is not finite", id="beyond floats in SI"),
        pytest.param("1e308 GPa", "GPa", "is not finite", id="beyond floats in SI, same unit"),
        pytest.param("60\nmm\x00", "mm", "is not a", id="control character"),
        pytest.param("6" * 10_000, "mm", "is not finite", id="ten thousand digits"),
        pytest.param("6 " + "m" * 10_000, "mm", "is not a", id="ten thousand letters"),
        pytest.param("6 " + "?" * 150, "mm", "is not a length", id="150 signs"),
    ],
)
def test_what_is_no_quantity_is_refused_in_one_short_line(text, unit, message):
    with pytest.raises(ValueError, match=message) as caught:
        units.parse(text, unit)
    said = str(caught.value)
    assert said.isprintable()  # and so one line
    assert len(said) < 120


def test_the_message_gives_the_text_the_rule_and_an_example():
    with pytest.raises(ValueError, match=r'^"60 N" is not a length, such as "1\.5 mm"$'):
        units.parse("60 N", "mm")


@pytest.mark.parametrize(
    "text",
    [
        pytest.param("1 " + "m" * 24 + "!", id="letters"),
        pytest.param("1 " + "m " * 12 + "!", id="words"),
        pytest.param("1 " + "m" * 24 + "^", id="a power without a number"),
        pytest.param("1 " + "µ" * 24 + "?", id="mu"),
        pytest.param("9" * 5000 + "!", id="5000 digits"),
        pytest.param("1" + " " * 5000 + "!", id="5000 blanks"),
    ],
)
def test_a_mistyped_quantity_is_refused_at_once(text):
    """In time that grows with the length, not with its square or with two to its power.

    Both take two seconds: 2^24 ways to part the letters, 5000^2/2 ways to part the digits.
    """
    start = time.perf_counter()
    with pytest.raises(ValueError, match="is not a"):
        units.parse(text, "mm")
    assert time.perf_counter() - start < 0.2


# Round trips.

LENGTHS = {"m": 1.0, "mm": 1e-3, "µm": 1e-6, "km": 1e3, "in": 0.0254}
numbers = st.floats(1e-30, 1e30) | st.floats(-1e30, -1e-30) | st.just(0.0)


@fixed
@given(numbers, st.sampled_from(sorted(LENGTHS)), st.sampled_from(["", " ", "  "]))
def test_what_python_prints_is_read_back(number, unit, gap):
    value = units.parse(f"{number!r}{gap}{unit}", "mm")
    assert value == pytest.approx(number * LENGTHS[unit], rel=4e-16)


@fixed
@given(numbers)
def test_plain_numbers_are_read_back_exactly(number):
    assert units.parse(repr(number), "1") == number


bases = st.sampled_from(["mm", "N", "MPa", "s", "deg", "kg", "J"])
powers = st.integers(-3, 3).filter(bool)


@fixed
@given(st.dictionaries(bases, powers, min_size=1, max_size=3), st.sampled_from(["*", " ", "·"]))
def test_a_product_of_powers_has_the_product_of_the_factors(parts, dot):
    text = dot.join(f"{name}^{power}" for name, power in parts.items())
    by_hand = {"mm": 1e-3, "N": 1, "MPa": 1e6, "s": 1, "deg": math.pi / 180, "kg": 1, "J": 1}
    expected = math.prod(by_hand[name] ** power for name, power in parts.items())
    assert units.factor(text) == pytest.approx(expected, rel=1e-14)  # some twenty roundings


@fixed
@given(st.dictionaries(bases, powers, min_size=1, max_size=3))
def test_a_unit_times_its_reciprocal_is_a_number(parts):
    both = [f"{name}^{power}" for name, power in parts.items()]
    both += [f"{name}^{-power}" for name, power in parts.items()]
    assert units.dimensions(" ".join(both)) == frozenset()
    assert units.factor(" ".join(both)) == pytest.approx(1.0, rel=1e-14)


def outcome(text, unit):
    try:
        return units.parse(text, unit)
    except ValueError as error:
        return str(error)


def is_finite_or_one_line(found):
    return math.isfinite(found) if isinstance(found, float) else found.isprintable()


@fixed
@given(st.text(max_size=40), st.sampled_from(["mm", "1", "deg"]))
def test_any_text_is_a_finite_number_or_one_line(text, unit):
    assert is_finite_or_one_line(outcome(text, unit))


@fixed
@given(st.from_regex(r"\A[-+]?\d{1,3}(\.\d{1,3})?(e-?\d{1,3})? ?[a-zA-Zµ°%*/^ 0-9-]{0,12}\Z"))
def test_what_looks_like_a_quantity_is_a_finite_number_or_one_line(text):
    assert is_finite_or_one_line(outcome(text, "mm"))


@pytest.mark.parametrize(
    "unit",
    [
        "",
        "mm!",
        "furlong",
        "1e3",
        "mm^",
        "m m m;",
        "__class__",
        "/mm",
        "*mm",
        "mm 1",
        "1 1",
        "mm//N",
    ],
)
def test_what_is_no_unit_has_no_factor(unit):
    with pytest.raises(ValueError, match="is not a"):
        units.factor(unit)


def test_angles_are_a_dimension_of_their_own():
    assert units.dimensions("rad") == units.dimensions("deg") != units.dimensions("1")


def test_a_registry_of_the_project_s_units_is_built_in_milliseconds():
    units.registry.cache_clear()
    start = time.perf_counter()
    units.registry()
    assert time.perf_counter() - start < 0.1  # the full one takes more than that and reads files


def test_a_decimal_comma_is_recognised():
    with pytest.raises(ValueError, match=r"has a comma: decimals follow a point"):
        units.parse("3,5 mm", "mm")


@pytest.mark.parametrize(("text", "metres"), [("1 ft", 0.3048), ("10 mil", 2.54e-4)])
def test_workshop_lengths(text, metres):
    assert units.parse(text, "mm") == pytest.approx(metres, rel=1e-12)


def test_an_unknown_unit_names_the_known_ones():
    with pytest.raises(ValueError, match=r"not a known unit: a length takes mm, m, in, ft or mil"):
        units.parse("3 furlong", "mm")


def test_every_unit_of_an_input_has_words_for_its_dimension():
    used = {
        meta(field)["unit"] for case in CASES for field in case.inputs.model_fields.values()
        if isinstance(meta(field).get("unit"), str)
    }  # fmt: skip
    assert "kg m^2" in used
    assert used - set(units.DIMENSIONS) == set()


def test_temperatures_and_stress_intensities_have_units():
    assert units.parse("293.15 K", "K") == 293.15
    assert units.parse("2 mK", "K") == pytest.approx(2e-3)
    assert units.parse("12e-6 1/K", "1/K") == 12e-6
    assert units.parse("1 MPa m^0.5", "MPa m^0.5") == pytest.approx(1e6, rel=1e-12)
    assert units.parse("1000 MPa mm^0.5", "MPa m^0.5") == pytest.approx(1e9 * 1e-3**0.5)
    assert units.factor("MPa mm^0.5") == pytest.approx(1e6 * 1e-3**0.5)
    with pytest.raises(ValueError, match='"degC" is not a known unit: a temperature takes K or mK'):
        units.parse("20 degC", "K")  # its zero is another one: the factor of a unit is no answer
    with pytest.raises(ValueError, match="is not a stress intensity"):
        units.parse("1 MPa", "MPa m^0.5")


@pytest.mark.parametrize("unit", units.TAKEN)
def test_units_that_a_message_offers_are_taken(unit):
    for offered in re.split(", | or ", units.TAKEN[unit]):
        assert math.isfinite(units.parse(f"1 {offered}", unit))


def test_rpm_is_a_revolution_a_minute():
    assert units.parse("60 rpm", "r/min") == pytest.approx(2 * math.pi)
