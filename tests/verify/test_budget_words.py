"""A budget says what was refined, not which level came after which."""

import pytest

from verify.studies.budget.balance import Balance, Part
from verify.studies.budget.found import RowBudget
from verify.studies.budget.measuring import plan_of
from verify.studies.budget.messages import OTHER, in_words


def said(case, name):
    """The name of a part in the case's words."""
    row = RowBudget(plan_of("ring-lame").rows[0], Balance(1.0, (Part(name, 1.0, 0.0),), 0.0, 0.0))
    (found,) = in_words(case, (row,))
    return found.balance.parts[0].name


@pytest.mark.parametrize(
    ("case", "name", "words"),
    [
        ("ring-lame", "level 20 after 16", "the next finer mesh"),
        ("sprag-clutch", "level 321 after 161", "more and narrower strips"),
        ("ring-lame", "Richardson from the three finest meshes",
         "Richardson from the three finest meshes"),
        ("sprag-friction", "Richardson from the three finest meshes",
         "Richardson from the three finest time steps"),
        ("sprag-engagement", "Richardson from the three finest meshes (no finer one: too long)",
         "Richardson from the three finest time steps (no finer one: too long)"),
    ],
)  # fmt: skip
def test_discretisation_is_told_in_the_case_s_words(case, name, words):
    assert said(case, f"discretisation: {name}") == f"discretisation: {words}"


def test_other_causes_keep_their_words():
    name = "finite geometry: level 3 after 2"
    assert said("ring-lame", name) == name


@pytest.mark.parametrize("case", OTHER)
def test_cases_with_other_words_have_budgets(case):
    assert plan_of(case).rows
