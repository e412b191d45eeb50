"""Each operator makes its stated changes only, and the changed code compiles."""

import ast

import pytest

from verify.audit.mutation.sites import Source, mutants
from verify.audit.mutation.subject_operators import FINITE_ELEMENTS, FORMULAS, JUDGING

EVERY = FORMULAS | JUDGING | FINITE_ELEMENTS


def source(text: str) -> Source:
    return Source("made.up", __file__, text, ast.parse(text))


def changed(operator: str, line: str) -> set[str]:
    """The line after each change that the operator makes in it."""
    of = source(f"def f(a, b, r_i, r_o, nu, gap):\n    return {line}\n")
    found = set()
    for one in mutants(of, {operator: EVERY[operator]}):
        one.place.put(one.node)
        compile(of.tree, "made up", "exec")
        found.add(ast.unparse(of.tree.body[0].body[0].value))
        one.place.put(one.place.node)
    assert ast.unparse(of.tree.body[0].body[0].value) == ast.unparse(ast.parse(line))
    return found


@pytest.mark.parametrize(
    ("operator", "line", "after"),
    [
        ("arithmetic", "a - b / r_i", {"a + b / r_i", "a - b * r_i"}),
        ("power", "nu ** 2", {"nu"}),
        ("sign", "-a", {"a"}),
        ("constant", "3 + a", {"4 + a", "6 + a", "1.5 + a", "-3 + a"}),
        ("constant", "0.5 * a", {"0.505 * a", "1.0 * a", "0.25 * a", "-0.5 * a"}),
        ("constant", "a + 0", {"a + 1"}),
        ("constant", "a + 1e-12", set()),  # guards against round-off
        ("comparison", "a < b", {"a >= b"}),
        ("boundary", "a < b <= nu", {"a <= b <= nu", "a < b < nu"}),
        ("function", "np.sin(a) + math.cos(b)", {"np.cos(a) + math.cos(b)",
                                                  "np.sin(a) + math.sin(b)"}),
        ("extreme", "max(a, b)", {"min(a, b)"}),
        ("extreme", "np.minimum(a, b)", {"np.maximum(a, b)"}),
        ("dropped", "np.sqrt(a + b)", {"a + b"}),
        ("condition", "a and not b", {"a or not b", "a and b"}),
        ("poisson", "(1 - nu ** 2) / a", {"1 / a"}),
        ("diameter", "self.d_w + a", {"self.d_w / 2 + a"}),
        ("assumption", "f('plane stress')", {"f('plane strain')"}),
        ("alike", "r_i * a", {"r_o * a"}),
        ("alike", "self.r_i * self.r_o", {"self.r_o * self.r_o", "self.r_i * self.r_i"}),
        ("alike", "x_1 * a", set()),  # no x_2 is at hand
        ("contact-sign", "gap * a", {"-gap * a"}),
        ("component", "{'bore': 'x'}", {"{'bore': 'y'}"}),
        ("quadrature", "_gauss(3)", {"_gauss(3 - 1)"}),
        ("quadrature", "Basis(mesh, intorder=4)", {"Basis(mesh, intorder=4 - 1)"}),
        ("state", "Status.PASS", {"Status.FAIL"}),
    ],
)  # fmt: skip
def test_an_operator_changes_what_it_states(operator, line, after):
    assert changed(operator, line) == after


GUARDED = '''
"""Words 1 + 2."""

TOL = 1e-3


def f(a: "1 + 2", *, n=3) -> float:
    """More words."""
    if a < 0:
        raise ValueError(f"needs {a + 1}")
    check(a - 1)
    assert a + 1
    b = np.zeros_like(a + 1) + brentq(g, xtol=4 * a)
    k = (a + 1).size
    return b[n - 1]
'''


def test_code_that_no_row_can_detect_is_not_changed():
    found = [(o.mutant.function, o.mutant.before) for o in mutants(source(GUARDED), FORMULAS)]
    assert set(found) == {
        ("TOL", "0.001"), ("f", "3"), ("f", "np.zeros_like(a + 1) + brentq(g, xtol=4 * a)"),
    }  # fmt: skip


def test_ids_are_unique_and_outlast_changes_of_other_code():
    text = "class A:\n    def f(self, a):\n        return a + a + a\n"
    before = [one.mutant.id for one in mutants(source(text), FORMULAS)]
    after = [one.mutant.id for one in mutants(source(f"X = 2 * 3\n\n\n{text}"), FORMULAS)]
    assert len(set(before)) == len(before) == 2
    assert after[-2:] == before
    assert all(key.startswith("made.up:A.f:arithmetic:") for key in before)


def test_linear_elements_replace_quadratic_ones_wherever_the_class_comes_from():
    (line,) = changed("element", "ElementTriP2()")
    element = eval(line)
    assert type(element).__name__ == "ElementTriP1"
