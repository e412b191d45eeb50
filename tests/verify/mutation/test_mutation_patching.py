"""A patch reaches the function by whatever name and through whatever wraps it."""

import importlib
from textwrap import dedent

import pytest

from analytic.contact.strip_influence import _cubics
from tests.verify.mutation.forked import answer
from verify.audit.mutation.patching import patch
from verify.audit.mutation.sites import mutants, source
from verify.audit.mutation.subject_operators import FORMULAS
from verify.audit.mutation.tracing import called

FORMULA = """
    from dataclasses import dataclass
    from functools import cache, cached_property, partial

    FACTOR = 7.5


    def area(a, b, *, scale=2.0):
        def inner():
            return a * b
        return scale * inner()


    @cache
    def kept(a):
        return a + 10


    def constant():
        return FACTOR


    @dataclass(frozen=True)
    class Ring:
        r: float

        @cached_property
        def size(self):
            return self.r - 1

        @property
        def twice(self):
            return self.size * 2

        @staticmethod
        def half(a):
            return a / 2


    bound = partial(area, 3.0)
"""
USER = """
    from weighed import FACTOR, area, kept

    def used():
        return area(3.0, 4.0), kept(5), FACTOR
"""


@pytest.fixture
def modules(tmp_path, monkeypatch):
    """A module of formulas and one that has imported its names."""
    for name, text in (("weighed", FORMULA), ("weighing", USER)):
        (tmp_path / f"{name}.py").write_text(dedent(text), "utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    source.cache_clear()
    yield importlib.import_module("weighed"), importlib.import_module("weighing")
    for name in ("weighed", "weighing"):
        monkeypatch.delitem(__import__("sys").modules, name)
    source.cache_clear()


def after(work, function, before, becomes):
    """What `work` gives in a child where that change is in place."""
    of = source("weighed")
    (one,) = (
        m for m in mutants(of, FORMULAS)
        if m.mutant.function == function and (m.mutant.before, m.mutant.after) == (before, becomes)
    )  # fmt: skip

    def changed():
        patch(of, one)
        return work()

    found = answer(changed, 20.0)
    assert not found.failure
    return found.value


def test_names_that_others_imported_are_reached(modules):
    formulas, user = modules
    assert user.used() == (24.0, 15, 7.5)
    formulas.kept.cache_clear()
    assert after(user.used, "kept", "a + 10", "a - 10") == [24.0, -5, 7.5]
    assert user.used() == (24.0, 15, 7.5)  # nothing comes back from the child


def test_defaults_are_replaced(modules):
    formulas, _ = modules
    assert after(lambda: formulas.area(3.0, 4.0), "area", "2.0", "4.0") == 48.0
    assert formulas.area(3.0, 4.0) == 24.0


@pytest.mark.parametrize(
    ("work", "function", "before", "becomes", "expected"),
    [
        (lambda m: m.Ring(5.0).twice, "Ring.size", "self.r - 1", "self.r + 1", 12.0),
        (lambda m: m.Ring(5.0).twice, "Ring.twice", "self.size * 2", "self.size / 2", 2.0),
        (lambda m: m.Ring.half(4.0), "Ring.half", "a / 2", "a * 2", 8.0),
    ],
)
def test_methods_and_properties_are_reached(modules, work, function, before, becomes, expected):
    formulas, _ = modules
    assert after(lambda: work(formulas), function, before, becomes) == expected


def test_a_constant_is_set_wherever_it_was_imported(modules):
    formulas, user = modules
    both = after(lambda: [formulas.constant(), user.used()[2]], "FACTOR", "7.5", "15.0")
    assert both == [15.0, 15.0]


def test_what_is_memoised_is_traced_as_well():
    _cubics()
    assert "analytic.contact.strip_influence:_slope" in called(_cubics)[1]
