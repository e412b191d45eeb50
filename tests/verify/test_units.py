"""Strings with units: input of a user, conversion to SI, and refused strings."""

import math
import re
import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verify.core import units

fixed = settings(deadline=None, derandomize=True)

# Definitions: SI brochure; inch 25.4 mm and pound 0.45359237 kg by the 1959 agreement, standard
# gravity 9.80665 m/s², so lbf = 4.4482216152605 N and psi = lbf/in².
PSI = 4.4482216152605 / 0.0254**2

READ = [
    ("11.6 mm", "mm", 0.0116),
    ("11600 µm", "mm", 0.0116),  # micro sign, U+00B5
    ("11600 μm", "mm", 0.0116),  # Greek mu, U+03BC
    ("10 mil", "mm", 2.54e-4),
    (".5 mm", "mm", 0.0005),
    ("5E+1mm", "mm", 0.05),
    ("206e3 N/mm^2", "MPa", 206e9),
    ("1 psi", "MPa", PSI),
    ("40 N·m", "N m", 40.0),
    ("300 Nm", "N m", 300.0),
    ("300kNm", "N m", 300e3),
    ("300 Nmm", "N m", 0.3),
    ("2 Nm/deg", "N m/rad", 360 / math.pi),
    ("2 Nms/rad", "N m s/rad", 2.0),
    ("2 Ns/mm", "N s/m", 2000.0),
    ("5 N/mm2", "MPa", 5e6),
    ("5 g/cm3", "kg/m^3", 5000.0),
    ("5 kg m2", "kg m^2", 5.0),
    ("1 kg m^2 / s^2 / rad", "N m/rad", 1.0),
    ("-7850 kg/m³", "kg/m^3", -7850.0),
    ("1 slug", "kg", 4.4482216152605 / 0.3048),
    ("1 lb in^2", "kg m^2", 0.45359237 * 0.0254**2),
    ("180°", "deg", math.pi),
    ("60 rpm", "r/min", 2 * math.pi),
    ("0.012 1/mm", "1/mm", 12.0),
    ("1000 MPa mm^0.5", "MPa m^0.5", 1e9 * 1e-3**0.5),
    ("30 %", "1", 0.3),
]


@pytest.mark.parametrize(("text", "unit", "value"), READ)
def test_a_quantity_is_read_in_si(text, unit, value):
    assert units.parse(text, unit) == pytest.approx(value, rel=4e-16)  # two roundings


REFUSED = [
    ("60 N", "mm", r'^"60 N" is not a length, such as "1\.5 mm"$'),
    ("60 mm", "1", "is not a number"),
    ("60", "mm", r'^"60" has no unit: needs a length, such as "60 mm"$'),
    ("300 nm", "N m", r'is not a torque, .* "nm" is nanometre, newton metre is "N m"$'),
    ("300 Nm", "mm", r'is not a length, .* "Nm" is newton metre, nanometre is "nm"$'),
    ("5 NM", "N m", "not a known unit"),
    ("5 Nmm^2", "N m", "is not a torque"),
    ("5 1/Nm", "N m", "is not a torque"),
    ("5 mm22", "mm", "is not a unit"),
    ("5 mm2^2", "mm", "is not a unit"),
    ("3 furlong", "mm", r"not a known unit: a length takes mm, m, in, ft or mil"),
    ("20 degC", "K", "a temperature takes K or mK"),  # its zero is another one
    ("60 mm^2^2", "mm", "is not a unit"),
    ("60 __import__('os')", "mm", "is not"),
    ("", "mm", "is not a length"),
    ("60,5 mm", "mm", "has a comma: decimals follow a point"),
    ("nan mm", "mm", "is not finite"),
    ("1e308 km", "mm", "is not finite"),
    ("60\nmm\x00", "mm", "is not a"),
    ("6 " + "m" * 10_000, "mm", "is not a"),
]


@pytest.mark.parametrize(("text", "unit", "message"), REFUSED, ids=[x[0][:20] for x in REFUSED])
def test_what_is_no_quantity_is_refused_in_one_short_line(text, unit, message):
    with pytest.raises(ValueError, match=message) as caught:
        units.parse(text, unit)
    printed = str(caught.value)
    assert printed.isprintable()  # and so one line
    assert len(printed) < 120


def test_a_mistyped_quantity_is_refused_at_once():
    """There are 2^24 divisions of the letters, 5000^2/2 of the digits: trying them takes 2 s."""
    for text in ("1 " + "m" * 24 + "!", "9" * 5000 + "!"):
        start = time.perf_counter()
        with pytest.raises(ValueError, match="is not a"):
            units.parse(text, "mm")
        assert time.perf_counter() - start < 0.2


BASES = {"mm": 1e-3, "N": 1, "MPa": 1e6, "s": 1, "deg": math.pi / 180, "kg": 1, "J": 1}
powers = st.dictionaries(
    st.sampled_from(sorted(BASES)), st.integers(-3, 3).filter(bool), min_size=1, max_size=3
)


@fixed
@given(powers, st.sampled_from(["*", " ", "·"]))
def test_a_product_of_powers_has_the_product_of_the_factors(parts, dot):
    text = dot.join(f"{name}^{power}" for name, power in parts.items())
    expected = math.prod(BASES[name] ** power for name, power in parts.items())
    assert units.factor(text) == pytest.approx(expected, rel=1e-14)  # some twenty roundings


@fixed
@given(st.text(max_size=40), st.sampled_from(["mm", "1", "deg"]))
def test_any_text_is_a_finite_number_or_one_line(text, unit):
    try:
        found = units.parse(text, unit)
    except ValueError as error:
        found = str(error)
    assert math.isfinite(found) if isinstance(found, float) else found.isprintable()


def test_units_that_a_message_offers_are_accepted():
    for unit, offered in units.TAKEN.items():
        for one in re.split(", | or ", offered):
            assert math.isfinite(units.parse(f"1 {one}", unit)), (unit, one)
