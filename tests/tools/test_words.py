"""The search for words of the list: texts that it reads, and its report."""

import re

import pytest

from tools.words import found, main, words

# the words are put together here, so that this file passes the check
ONE, TWO = "o" + "wn", "w" + "ay"
LISTED = words(
    [
        {"pattern": ONE, "instead": "leave out"},
        {"pattern": f"{TWO}s?", "instead": "path", "allowed": [f"one-{TWO} clutch", f"half {TWO}"]},
    ]
)


def findings(tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return [(number, word) for number, word, _ in found(path, LISTED)]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.py", f"x = 1\ny = 2  # its {ONE} mesh\n"),
        ("a.py", f'"""A module.\n\nIts {ONE} mesh.\n"""\n'.replace("\n\n", "\n")),
        ("a.py", f'x = 1\ny = f"its {ONE} mesh {{x}}"\n'),
        ("a.py", f"x = 1\ny = f\"{{x or '{ONE}'}}\"\n"),
        ("a.md", f"# Title\nIts {ONE} mesh.\n"),
        ("a.js", f"let x = 1;\nlet y = `its {ONE} ${{x}}`;\n"),
        ("a.html", f"<p>\nits {ONE} mesh</p>\n"),
        ("a.typ", f"#let x = 1\n#x.y its {ONE} mesh\n"),
        ("a.html.j2", f"<p>\n{{{{ x.y }}}} its {ONE} mesh</p>\n"),
    ],
    ids=["comment", "docstring", "f-string", "nested", "document", "script", "page", "typst", "j2"],
)  # fmt: skip
def test_a_listed_word_is_found_in_its_line(tmp_path, name, text):
    assert findings(tmp_path, name, text) == [(2, ONE)]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.py", f"{ONE} = 1\nx = f'{{{ONE}}} mesh'\n"),
        ("a.py", f"# is_{ONE}, {ONE}_mesh, no-{ONE}, the name `{ONE}`\n"),
        ("a.py", f"x = {{'{ONE}': 1}}\ny = x['{ONE}']\n"),
        ("a.js", f"const {ONE} = `a ${{{ONE}}}`\n"),
        ("a.html", f"<script>\nlet {ONE} = 1\n</script>\n"),
        ("a.typ", f"#{ONE} #x.{ONE}\n"),
        ("a.html.j2", f'<p class="{ONE}">{{{{ x.{ONE} }}}}{{% if {ONE} %}}</p>\n'),
    ],
)
def test_an_identifier_is_not_found(tmp_path, name, text):
    assert findings(tmp_path, name, text) == []


def test_an_allowed_phrase_is_not_found(tmp_path):
    assert findings(tmp_path, "a.md", f"A one-{TWO} clutch, half {TWO}.\n") == []
    assert findings(tmp_path, "a.md", f"A one-{TWO} clutch in this {TWO}.\n") == [(1, TWO)]


def test_words_are_found_in_any_case(tmp_path):
    assert findings(tmp_path, "a.md", f"{ONE.upper()} {TWO.title()}s\n") == [
        (1, ONE.upper()),
        (1, f"{TWO.title()}s"),
    ]


def test_exit_status_is_1_with_a_finding(tmp_path, capsys):
    path = tmp_path / "a.md"
    path.write_text(f"Plain.\nIts {ONE} mesh.\n", encoding="utf-8")
    assert main([str(path)]) == 1
    assert re.fullmatch(rf"\S*a\.md:2: {ONE}: .+\n", capsys.readouterr().out)
    path.write_text("Plain.\n", encoding="utf-8")
    assert main([str(path)]) == 0
    assert capsys.readouterr().out == ""
