"""Names offered in the place of an unknown one."""

from verify.app.cli import run
from verify.core.suggestions import FEW, nearest


def test_names_like_it_stand_first_and_of_many_few_are_shown():
    known = [*(f"other {k}" for k in range(20)), "ring-lame"]
    said = nearest("ring-lam", known)
    assert said.startswith("ring-lame, other 0, ")
    assert said.endswith(f" and {21 - FEW} more")


def test_few_names_are_all_shown_in_their_order():
    assert nearest("x", ["b", "a"]) == "b, a"
    assert nearest("", [str(k) for k in range(9)], most=9, between="; ").count("; ") == 8


def test_a_typo_is_answered_in_a_short_line(capsys):
    for words in (["crosscheck", "ring-lam"], ["deep", "budget:ring-lam"],
                  ["deep", "validity:ring-lam"], ["verify", "ring-lam"]):  # fmt: skip
        assert run(words) == 2
        said = capsys.readouterr().err
        assert "ring-lame, " in said
        assert len(said) < 260
        assert said.count("\n") == 1
    assert run(["deep", "budget:"]) == 2
    assert "budget: no such measurement" in capsys.readouterr().err


def test_both_complaints_of_a_key_list_the_same_keys(capsys):
    assert run(["search", "ring-lame"]) == 2
    needed = capsys.readouterr().err.partition("one of ")[2]
    assert run(["search", "ring-lame", "--key", "hoop_rm", "--printed", "1"]) == 2
    wrong = capsys.readouterr().err.partition("ring-lame has ")[2]
    assert wrong.startswith("hoop_rim; ")
    assert sorted(needed.strip().split("; ")) == sorted(wrong.strip().split("; "))
