"""A case declared by one class: results of a declaration, and reported violations of rules."""

import pickle
from collections.abc import Iterator
from math import log, pi
from typing import ClassVar

import numpy as np
import pytest

from verify.case import (
    AlongLine,
    Case,
    CaseError,
    Comparison,
    Drawn,
    Expected,
    Level,
    Quantity,
    State,
    approximation,
    as_printed,
    balance,
    errors_of,
    given,
    identity,
    shared,
    solved,
)
from verify.core.case import Context
from verify.form import equations
from verify.form.adapter import adapted
from verify.form.members import reached
from verify.form.quantity import forget
from verify.jobs.level import Job, judge_case, solve_level
from verify.judging.checks import Order

LOW, HIGH = -0.003, 0.003


class Rod(Case):
    """A rod in tension."""

    title = "Rod"
    source = "belcin"
    ends: ClassVar[str] = "plane stress"

    d: float = given("10 mm", "mm", "d", "diameter", gt=0)
    F: float = given("1 kN", "kN", "F", "force")
    E: float = given("200 GPa", "GPa", "E", "Young's modulus", gt=0)

    @Quantity("A", "mm^2", "area", role="geometry", tex=r"\frac{\pi d^2}{4}")
    def area(self) -> float:
        return pi * self.d**2 / 4

    @Quantity("σ", "MPa", "stress", equation="1", safe="too high")
    def sigma(self) -> float:
        return self.F / self.area

    @Quantity("ε", "1", "strain", equation="2")
    def strain(self) -> float:
        return self.sigma / self.E

    @shared
    def state(self) -> np.ndarray:
        return np.full(3, self.sigma)

    def reference(self, level: int) -> Level:
        stress = self.F / self.area * (1 + 1e-3 / level**2)
        return solved(1 / level, sigma=stress, strain=self.F / self.area / self.E, rest=0.0,
                      sigma_more=2 * stress, both=np.repeat([stress, 10 * stress], 5))  # fmt: skip

    def comparisons(self) -> Iterator[Comparison]:
        wide = Expected(LOW, HIGH * self.d / 10e-3, "book")
        yield identity(Rod.strain, order=2, against="the mesh")
        yield approximation(Rod.sigma, order=2, expected=wide)
        yield balance("rest", "balance", "ΣF", "N", of={"force": self.F}, bound=1e-9, because="sum")


def context_of(case, inputs, levels=4):
    solutions = [case.reference(inputs, level) for level in case.levels[:levels]]
    return Context(case.id, inputs, case.analytic(inputs), solutions, inputs == case.inputs())


def rows_of(case, inputs):
    context = context_of(case, inputs)
    return {r.quantity: r for c in case.checks for r in c.rows(context)}


def test_a_class_becomes_a_case_with_names_outputs_numbers_and_intervals():
    rod, case = Rod(d=20e-3), adapted(Rod)
    assert rod.sigma == pytest.approx(1e3 / (pi * 1e-4))
    assert (Rod.sigma.name, Rod.sigma.label) == ("sigma", "stress, Eq. 1")
    assert [q.name for q in Rod.quantities()] == ["area", "sigma", "strain"]
    assert rod.at(F=2e3).sigma == pytest.approx(2 * rod.sigma)
    assert rod.shown("sigma") == "3.183 MPa"
    assert [check.name for check in case.checks] == [
        "strain, Eq. 2, against the mesh", "stress, Eq. 1", "balance",
    ]  # fmt: skip
    judged = {one.key: one.judged for one in case.outputs}
    assert judged == {"area": False, "sigma": True, "strain": True}
    assert case.analytic(Rod())["force"] == 1e3
    assert case.lead == "A rod in tension."
    for d, high in ((10e-3, HIGH), (5e-3, HIGH / 2)):  # at the inputs at hand
        assert case.checks[1].interval(Rod(d=d), {}) == (LOW, high)


def test_a_reference_that_reads_a_formula_is_an_error():
    for formula in ("sigma", "state"):

        class Reads(Rod):
            def reference(self, level, formula=formula):
                return solved(1 / level, sigma=getattr(self, formula))

        with pytest.raises(
            CaseError, match=rf"{formula}: the reference (reads this|must not read)"
        ):
            adapted(Reads).reference(Reads(), 1)
        assert Reads().sigma > 0  # formulas are there again


def test_computed_values_are_no_part_of_the_inputs(monkeypatch):
    rod = Rod()
    stress = rod.state[0]
    other = rod.model_copy(update={"F": 2e3})
    assert other.sigma == pytest.approx(2 * stress)
    assert dict(rod) == {"d": 10e-3, "F": 1e3, "E": 200e9}
    sent = pickle.loads(pickle.dumps(rod))
    assert not [key for key in sent.__dict__ if key.startswith("=")]
    assert sent == rod == Rod()
    assert hash(rod) == hash(Rod())
    assert rod != Rod(d=20e-3)
    assert rod != rod.model_copy(update={"ends": "plane strain"})
    # replaced code is computed again
    monkeypatch.setattr(Rod.sigma, "formula", lambda self: 7.0)
    assert rod.sigma == stress
    forget()
    assert rod.sigma == 7.0


def test_equations_come_from_the_code_or_are_checked_against_it():
    found = {one.tex: one for one in equations.stated(Rod())}
    assert list(found) == [
        r"A = \frac{\pi d^2}{4}", r"\sigma = \frac{F}{A}", r"\varepsilon = \frac{\sigma}{E}",
    ]  # fmt: skip
    assert found[r"\sigma = \frac{F}{A}"].numbers == (
        r"= \frac{1\,\mathrm{kN}}{78.5398\,\mathrm{mm^2}} = 12.7324\,\mathrm{MPa}"
    )

    class Wrong(Rod):
        @Quantity("G", "GPa", "shear modulus", tex=r"\frac{E}{3}")
        def G(self):
            return self.E / 2.6

    with pytest.raises(CaseError, match=r"test_declared.py:\d+: Wrong.G: the equation E/3 gives"):
        equations.stated(Wrong())


def test_a_broken_rule_is_found_where_the_class_is_made():
    for symbol, unit, rule in (
        ("σ", "MPa", r"Broken.other: the symbol σ is already used by sigma"),
        ("d", "mm", r"Broken.other: the symbol d is already used by d"),
        ("x", "furlong", r"Broken.other: .*furlong"),
    ):
        with pytest.raises(CaseError, match=rf"^test_declared.py:\d+: {rule}"):

            class Broken(Rod):
                @Quantity(symbol, unit, "something else")
                def other(self):
                    return 1.0


def test_two_comparisons_of_one_name_are_refused():
    class Twice(Rod):
        def comparisons(self):
            yield from (identity(Rod.strain), identity(Rod.sigma), identity(Rod.strain))

    rule = r"Rod.strain: two comparisons have the name strain, E"
    with pytest.raises(CaseError, match=rf"^test_declared.py:\d+: {rule}"):
        len(adapted(Twice).checks)


def test_the_reference_consists_of_what_it_uses_and_of_no_formula():
    ((module, name, members),) = reached(Rod, ["reference"], formulas=False)
    assert (module, name) == (Rod.__module__, "Rod")
    assert set(members) == {"reference", "area", "d", "F", "E"}
    ((*_, members),) = reached(Rod, ["strain"], formulas=True)
    assert set(members) == {"strain", "sigma", "area", "d", "F", "E"}


# Quantities and states that some inputs do not have


class Column(Case):
    """A column that is pushed, buckles, and may not exist in a state."""

    title = "Column"
    F: float = given("1 N", "N", "F", "force")

    @Quantity("S", "1", "safety against buckling under a push", tex=r"\frac{2}{F}")
    def S(self) -> float:
        return 2 / self.F if self.F > 0 else float("nan")

    @Quantity("l", "1", "a logarithm", role="step", when=lambda q: q.F > 0)
    def level(self) -> float:
        return log(self.F)

    def comparisons(self):
        for q in (Column.S, Column.level):
            yield identity(q, state=State(self.at(F=2 * self.F), "twice", "2 F"))


def test_what_a_part_does_not_have_is_no_value_and_no_equation():
    case = adapted(Column)
    assert case.analytic(Column()) == {
        "S": 2.0, "level": 0.0, "S_twice": 1.0, "level_twice": log(2),
    }  # fmt: skip
    assert len(case.equations(Column(), {})) == 2
    pulled = Column(F=-1.0)
    assert pulled.present() == case.equations(pulled, {}) == ()
    assert case.analytic(pulled) == {}  # of no state, either


@pytest.mark.parametrize(
    ("solution", "F", "reason"),
    [
        ({}, 1.0, "the reference has no value of S_twice"),
        ({"S_twice": 1.0}, -1.0, "the formulas have no value of S_twice, or it is nan or inf"),
    ],
)
def test_a_number_that_a_side_does_not_give_is_named(solution, F, reason):
    class Solved(Column):
        def reference(self, level):
            return solved(1 / level, **solution)

        def comparisons(self):
            yield identity(Column.S, state=State(self.at(F=2 * self.F), "twice", "2 F"))

    case, q = adapted(Solved), Solved(F=F)
    levels = [solve_level(case, q, level, None) for level in case.levels]
    (*_, row) = judge_case(Job(case, q), levels).rows
    assert (row.status, row.reason) == ("FAIL", f"ValueError: {reason}")


# Options of comparisons and figures


class Pair(Rod):
    """A rod and the same one under twice its force."""

    printed: ClassVar[str] = "12.732 MPa"

    def comparisons(self):
        more = State(self.at(F=2 * self.F), "more", "under 2 F", "{}(2F)")
        yield identity(Pair.sigma, order=2, own=(0.05, "coarse"), uncertainty=1e-5, shares="area")
        yield identity(Pair.sigma, order=2, state=more, scale={"twice": 2 * self.sigma})
        yield Order(name="order", symbol="p", unit="1", order=2,
                    errors=errors_of(Pair.sigma, state=more))  # fmt: skip
        yield as_printed(Pair.sigma, self.printed)

    def figures(self):
        for part, factor in (((None, 5), 1), ((5, None), 10)):
            yield AlongLine(
                title="Stress", x=("x", "mm"), y=("σ", "MPa"), at=np.linspace(0, 1e-3, 5), order=2,
                curve=lambda x, factor=factor: np.full_like(x, factor * self.sigma), part=part,
                reference="both", scale=self.sigma,
            )  # fmt: skip
        yield Drawn(lambda _: [])


def test_states_and_options_reach_their_rows():
    case = adapted(Pair)
    rows, own = rows_of(case, Pair()), rows_of(case, Pair(d=20e-3))
    first, more = rows["stress, Eq. 1"], rows["stress, Eq. 1, under 2 F"]
    assert (more.symbol, more.formula, more.scale_name) == ("σ(2F)", "sigma_more", "twice")
    assert more.analytic == more.scale == pytest.approx(2 * first.analytic)
    output = {one.key: one for one in case.outputs}["sigma_more"]
    assert (output.what, output.symbol, output.safe) == (more.quantity, "σ(2F)", "too high")
    assert (first.formula, first.shares, first.demand) == ("sigma", "area", 0.01)
    assert first.u_ref == pytest.approx(1e-5 * first.scale)
    own_first = own["stress, Eq. 1"]
    assert (own_first.demand, own_first.demand_reason) == (0.05, "coarse")
    assert rows["order"].fem == pytest.approx(2)
    assert "stress, Eq. 1, as printed" not in own  # it speaks of the paper's inputs alone


def test_the_last_digit_of_another_source_s_number_decides():
    class Book(Pair):
        printed: ClassVar[str] = "12.74 MPa"

    for made, by, status in ((Pair, "12.732", "PASS"), (Book, "12.74", "FAIL")):
        row = rows_of(adapted(made), made())["stress, Eq. 1, as printed"]
        assert (row.status, row.partner.by) == (status, f"printed {by}")


def test_figures_along_a_line_take_their_part_of_an_array_in_their_units():
    case = adapted(Pair)
    first, second = case.figures(context_of(case, Pair()))
    assert (first.x_label, first.y_label) == ("x [mm]", "σ [MPa]")
    assert first.x[-1] == 1.0
    assert first.y[0] == pytest.approx(12.732, rel=1e-4)
    assert (first.u > 0).all()
    assert second.y_fem == pytest.approx(10 * first.y_fem)
    assert len(first.x_fem) == len(first.y_fem) == len(first.u) == 5
    # without levels enough for its uncertainty it is not drawn
    assert case.figures(context_of(case, Pair(), levels=2)) == ()
