"""Rules for equations and expected errors of a case: of the suite here, of users at the start."""

from math import log, pi

import pytest

from verify.case import (
    Case,
    CaseError,
    Computed,
    Expected,
    Quantity,
    State,
    approximation,
    given,
    identity,
    shared,
    solved,
)
from verify.cases.registry import CASES
from verify.form import dimensions, independence
from verify.form.adapter import adapted


class Rod(Case):
    """A rod in tension."""

    title = "Rod"
    source = "belcin"

    d: float = given("10 mm", "mm", "d", "diameter", gt=0)
    F: float = given("1 kN", "kN", "F", "force")
    n: float = given("60 r/min", "r/min", "n", "speed")
    k: float = given(2.0, "1", "k", "exponent")

    @Quantity("A", "mm^2", "area", role="geometry", tex=r"\frac{\pi d^2}{4}")
    def area(self) -> float:
        return pi * self.d**2 / 4

    @Quantity("σ", "MPa", "stress", equation="1")
    def sigma(self) -> float:
        return self.F / self.area

    @Quantity("p", "MPa", "no less than nothing: a number has any dimension")
    def p(self) -> float:
        return max(self.sigma - 2 * self.sigma, 0)

    @Quantity("v", "m/s", "speed of the rim: an angle is a number")
    def v(self) -> float:
        return self.n * self.d / 2


def limited(form):
    """The case outside the suite, whose checks are made at its start."""
    return adapted(form, time_limit=60.0)


def test_equations_give_what_units_state():
    for case in CASES:
        dimensions.check(case.inputs())


@pytest.mark.parametrize(
    ("unit", "tex", "more", "rule"),
    [
        (
            "mm",
            r"\frac{F}{A}",
            {},
            "the unit mm is a length, but the equation F/A gives a pressure or s",
        ),
        (
            "mm^4",
            "d^3",
            {},
            r"the unit mm\^4 is \[length\]\^4, but the equation d\^3 gives \[length\]\^3",
        ),
        ("mm", "A^k", {}, r"the equation A\^k contains \[length\]\^2 with a variable exponent"),
        ("mm", r"\min(d, F)", {}, r"the equation min\(d, F\) compares a length and a force"),
        (
            "MPa",
            r"\frac{F}{A} = F A",
            {},
            "the unit MPa is a pressure or stress, but the equation F A",
        ),
        # what is fitted, or no arithmetic, has no dimension
    ],
)
def test_a_unit_that_the_equation_does_not_give_is_an_error(unit, tex, more, rule):
    class Wrong(Rod):
        @Quantity("x", unit, "something", tex=tex, **more)
        def x(self):
            return 1.0

    if not rule:
        assert len(limited(Wrong).checks) == 0
        return
    with pytest.raises(CaseError, match=rf"^test_rules.py:\d+: Wrong.x: {rule}"):
        len(limited(Wrong).checks)


def test_a_formula_that_reads_itself_is_named_with_what_it_reads():
    class Circle(Rod):
        @Quantity("a", "mm", "first")
        def a(self):
            return self.b + self.d

        @Quantity("b", "mm", "second")
        def b(self):
            return self.middle

        @shared
        def middle(self):
            return 2 * self.a

    case = Circle()
    rule = "circular dependence: a reads b, b reads middle, middle reads a$"
    for _ in range(2):  # nothing of the first attempt is stored
        with pytest.raises(CaseError, match=rf"^test_rules.py:\d+: Circle.a: {rule}"):
            _ = case.a


# An expected error may not follow the formula that it judges


def expecting(low, high, *, computed=False):
    """A case whose stress is expected to err by what two functions give of it."""

    class Judged(Rod):
        def comparisons(self):
            interval = Expected(low(self), high(self), "book")
            if computed:
                interval = Computed(lambda: (low(self), high(self)), "book")
            yield identity(Judged.area, scale={"of its stress": self.sigma * self.d**4})
            yield approximation(Judged.sigma, expected=interval)
            yield approximation(Judged.sigma, expected=Expected(-0.1, 0.1, "wide"),
                                state=State(self.at(F=2 * self.F), "double", "2 F"))  # fmt: skip

    return Judged


def exact(q):
    return 4 * q.F / (pi * q.d**2)


FOLLOWS = {
    "an error": (lambda q: q.sigma / exact(q) - 1.01, lambda q: q.sigma / exact(q) - 0.99),
    "one end": (lambda _: -0.01, lambda q: q.sigma / exact(q) - 0.99),
}


@pytest.mark.parametrize("ends", FOLLOWS.values(), ids=FOLLOWS)
@pytest.mark.parametrize("computed", [False, True])
def test_an_expected_error_that_reads_its_formula_is_an_error(ends, computed):
    form = expecting(*ends, computed=computed)
    _, check, other = limited(form).checks
    rule = r"Rod.sigma: its expected error reads this formula"
    with pytest.raises(CaseError, match=rf"^test_rules.py:\d+: {rule}"):
        check.interval(form(), {})
    assert other.interval(form(), {}) == (-0.1, 0.1)
    assert adapted(form).checks[1].interval(form(), {})  # of the suite


class Steps(Rod):
    """The stress by an area that is a step, a shared value, and another formula."""

    @Quantity("A_s", "mm^2", "area", role="step")
    def step(self):
        return pi * self.d**2 / 4

    @shared
    def bore(self):
        return pi * self.d**2 / 4

    @Quantity("σ_1", "MPa", "stress by a step")
    def of_step(self):
        return self.F / self.step

    @Quantity("σ_2", "MPa", "stress by another formula", tex="F")
    def of_formula(self):
        return 2 * self.of_step / 2


@pytest.mark.parametrize(
    ("q", "low", "reads"),
    [
        (Steps.of_step, lambda s: s.F / s.step / exact(s) - 1.01, "step, as this formula does"),
        (Steps.of_formula, lambda s: s.of_step / exact(s) - 1.01, "of_step, as this formula does"),
        (Steps.of_step, lambda s: s.F / s.bore / exact(s) - 1.01, ""),
    ],
    ids=["step", "formula", "what the formula does not read"],
)  # fmt: skip
def test_an_expected_error_may_not_follow_what_its_formula_reads(q, low, reads):
    class Judged(Steps):
        def comparisons(self):
            yield approximation(q, expected=Expected(low(self), 0.1, "book"))

    (one,) = Judged().stated()
    assert bool(independence.follows(Judged(), one)) == bool(reads)
    if reads:
        with pytest.raises(CaseError, match=f"its expected error reads {reads}"):
            independence.check(Judged(), one)


def test_an_expected_error_may_depend_on_inputs_and_on_the_size_of_the_formula():
    """As the size of a cell over a width that the formula gives; low must not be above high."""
    form = expecting(lambda q: q.d, lambda q: 0.01 * log(q.sigma))
    found = limited(form).checks[1].interval(form(), {})
    assert found == (0.01, 0.01 * log(form().sigma))
    for ends in ((0.01, -0.01), (float("nan"), 0.01)):
        rule = "the lower limit of the expected error must not exceed the upper limit, got .* to "
        with pytest.raises(CaseError, match=rf"^test_rules.py:\d+: Rod.sigma: {rule}"):
            len(limited(expecting(lambda _: ends[0], lambda _: ends[1])).checks)  # noqa: B023


# What is stated wrongly


def test_a_number_without_a_unit_has_the_unit_1():
    with pytest.raises(ValueError, match=r'is not a unit; a plain number has the unit "1"$'):
        given("0.3", "", "ν", "Poisson's ratio")
    with pytest.raises(ValueError, match=r'of l must have a unit: write it as "20.0 mm"$'):
        given(20.0, "mm", "l", "length")


def test_a_comparison_that_is_stated_wrongly_is_an_error():
    for stated_as, message in (
        ({"expected": Expected(-0.01, 0.01, "s"), "ordr": 2}, "comparisons have no argument ordr"),
        ({"expected": Expected(-0.01, 0.01, "")}, "give the source of the expected error"),
    ):
        with pytest.raises(CaseError, match=rf"test_rules.py:\d+: Rod.sigma: {message}"):
            approximation(Rod.sigma, **stated_as)


def test_a_reference_without_numbers_is_an_error():
    for result, message in (
        (None, r"must return solved\(...\), got NoneType"),
        (solved(1.0, sigma=float("nan")), "the value sigma must be finite, got nan"),
    ):

        class Faulty(Rod):
            def reference(self, level, result=result):
                return result

        with pytest.raises(
            CaseError, match=f"test_rules.py: Faulty.reference: level 1:? {message}"
        ):
            limited(Faulty).reference(Faulty(), 1)
