"""Quantities with an index, states with separate symbols, the smaller of two in an equation."""

import pytest

from verify.case import Case, CaseError, Quantity, State, count, given, identity
from verify.form import equations
from verify.form.adapter import adapted
from verify.form.members import reached


class Beam(Case):
    """A beam with two modes, as a light and as a heavy one."""

    title = "Beam"
    source = "belcin"

    k: float = given("4 N/mm", "N/mm", "k", "stiffness", gt=0)
    m: float = given("1 kg", "kg", "m", "mass", gt=0)

    nodes: int = count(4, "", "number of nodes, without a symbol", ge=1)

    @Quantity("ω_{0}{1[0]}", "rad/s", "mode {0} {1}").over((1, 2), ("forward", "backward"))
    def whirl(self, j, way):
        return j * (self.k / self.m) ** 0.5 * self._gyroscopic(way)

    def _gyroscopic(self, way):
        return 1.1 if way == "forward" else 0.9

    @Quantity("q", "1", "heavy over light", tex=r"\frac{\omega_{1f}'}{\omega_{1f}}")
    def ratio(self):
        return self.heavy().whirl(1, "forward") / self.whirl(1, "forward")

    @Quantity("k_m", "N/mm", "the smaller stiffness")
    def softest(self) -> float:
        return min(self.k, 2 * self.k)

    def heavy(self):
        return self.at(m=4 * self.m)

    def comparisons(self):
        yield identity(Beam.whirl(1, "forward"), state=State(self.heavy(), "heavy", "heavy", "{}'"))


def test_members_are_quantities_with_names_numbers_and_the_code_of_their_method():
    names = ["whirl_1_forward", "whirl_1_backward", "whirl_2_forward", "whirl_2_backward"]
    assert [q.name for q in Beam.quantities()] == [*names, "ratio", "softest"]
    q = Beam.whirl(2, "backward")
    assert (q.symbol, q.what) == ("ω_2b", "mode 2 backward")
    beam = Beam()
    assert beam.whirl(2, "backward") == beam.whirl_2_backward == pytest.approx(2 * 0.9 * 4000**0.5)
    assert adapted(Beam).analytic(beam)["whirl_1_forward"] == beam.whirl(1, "forward")
    ((*_, members),) = reached(Beam, ["whirl_1_forward"], formulas=True)
    assert set(members) == {"whirl", "_gyroscopic", "k", "m"}
    with pytest.raises(CaseError, match=r"^test_family.py:\d+: Same.any_1: the symbol k"):

        class Same(Beam):
            @Quantity("k", "N/mm", "another").over((1, 2))
            def any(self, j):
                return j


def test_symbols_of_a_state_and_the_smaller_of_two_are_in_equations():
    found = {one.tex.partition(" = ")[0]: one for one in equations.stated(Beam())}
    assert found["q"].numbers.endswith(r" = 0.5")
    assert r"34.7851\,\mathrm{rad/s}" in found["q"].numbers
    assert found["k_m"].tex == r"k_m = \min\left(k, 2 k\right)"
    assert found["k_m"].numbers.endswith(r"= 4\,\mathrm{N/mm}")
