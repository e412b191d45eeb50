"""Parameter files with lists of tables: what is read, shown, written, and what is refused."""

import json
import tomllib

import pytest
from pydantic import model_validator

from verify.answers.template import template
from verify.cases.ring.lame.case import LAME
from verify.core.case import Case
from verify.core.inputs import EntryError, InputError, Inputs, build, count, quantity, table, text
from verify.jobs import cache


class Post(Inputs):
    """An entry."""

    at: int = count(1, "", "place", ge=1, le=9)
    k: float = quantity("2 N/mm", "N/mm", "k", "stiffness", gt=0)
    c: float = quantity("0 N s/m", "N s/m", "c", "damping", omitted=0.0, ge=0)
    play: float | None = quantity(None, "mm", "s", "play", omitted=None, example="0.1 mm")
    kind: str = text("wood", "what it is of", omitted="wood")

    @model_validator(mode="after")
    def _firm(self):
        if self.play is not None and self.play > 1:
            raise ValueError(f"play = {self.play * 1e3:g} mm: the post falls out")
        return self


class Fence(Inputs):
    """Posts, some of them, and rails, maybe."""

    length: float = quantity("3 m", "mm", "L", "length", gt=0)
    posts: tuple[Post, ...] = table((Post(at=1), Post(at=3, k=5e3)), "Posts.", required=True)
    rails: tuple[Post, ...] = table((), "Rails.")

    @model_validator(mode="after")
    def _apart(self):
        places = [post.at for post in self.posts]
        for k, at in enumerate(places, start=1):
            if at in places[: k - 1]:
                raise EntryError("posts", k, f"at = {at}", "a post is there already")
        return self


POST = {"at": 2, "k": "3 kN/m"}
GOOD = {"length": "2 m", "posts": [POST, {"at": 4, "k": "1 N/mm", "c": "5 N s/mm"}]}


def test_each_entry_is_read_in_its_own_units():
    fence = build(Fence, GOOD, "f.toml")
    assert [post.at for post in fence.posts] == [2, 4]
    assert [post.k for post in fence.posts] == pytest.approx([3e3, 1e3])
    assert [post.c for post in fence.posts] == pytest.approx([0.0, 5e3])
    assert fence.rails == ()


def test_tables_of_toml_are_entries():
    text = "length = '2 m'\n[[posts]]\nat = 2\nk = '3 kN/m'\n[[posts]]\nat = 4\nk = '1 N/mm'\n"
    inline = "length = '2 m'\nposts = [{at = 2, k = '3 kN/m'}, {at = 4, k = '1 N/mm'}]\n"
    one, other = (build(Fence, tomllib.loads(t), "f.toml") for t in (text, inline))
    assert one == other == build(Fence, GOOD | {"posts": [POST, {"at": 4, "k": "1 N/mm"}]}, "f")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"posts": [POST, {"at": 31, "k": "1 N/mm"}]}, "inputs.posts[2].at = 31: must be at most"),
        ({"posts": [POST, {"at": 3, "k": 5.0}]}, "inputs.posts[2].k: 5.0 has no unit: needs a"),
        ({"posts": [POST, {"at": 3}]}, "inputs.posts[2]: missing k"),
        ({"posts": [POST | {"high": 3}]}, "inputs.posts[1].high: unknown key; known are at, k, c"),
        ({"posts": [POST | {"kind": ""}]}, "inputs.posts[1].kind: needs a printable text, got ''"),
        ({"posts": [POST | {"play": "2 m"}]}, "inputs.posts[1]: play = 2000 mm: the post falls"),
        ({"posts": [POST, POST]}, "inputs.posts[2].at = 2: a post is there already"),
        ({"posts": POST}, "inputs.posts: needs tables [[inputs.posts]], got {'at': 2"),
        ({"posts": [POST] * 1001}, "inputs.posts: has 1001 entries, at most 1000"),
    ],
)  # fmt: skip
def test_a_fault_names_table_entry_and_key(change, message):
    with pytest.raises(InputError) as found:
        build(Fence, GOOD | change, "f.toml")
    assert str(found.value).startswith(f"f.toml: {message}")
    assert "\n" not in str(found.value)


def test_a_report_shows_an_entry_in_a_line_without_what_was_left_out():
    shown = build(Fence, GOOD, "f.toml").display()
    assert [(i.symbol, i.what, i.value) for i in shown] == [
        ("L", "length", 2000.0), ("posts[1]", "at 2, k 3 N/mm", ""),
        ("posts[2]", "at 4, k 1 N/mm, c 5000 N s/m", ""),
    ]  # fmt: skip


def test_programs_get_entries_with_values_and_units():
    found = build(Fence, GOOD, "f.toml").record()
    assert found["length"] == {"value": 2000.0, "unit": "mm"}
    assert found["posts"][0]["k"] == {"value": 3.0, "unit": "N/mm"}
    assert found["posts"][1]["kind"] == {"value": "wood", "unit": "1"}
    assert "play" not in found["posts"][1]
    assert found["rails"] == []
    assert json.loads(json.dumps(found)) == found


def fenced():
    return Case(
        id="fence", title="Fence", paper="huang2022", place="", lead="", inputs=Fence,
        analytic=lambda _: {}, reference=LAME.reference, levels=(1,), checks=(), outputs=(),
    )  # fmt: skip


def test_a_template_has_every_table_with_its_comments_once():
    written = template(fenced())
    assert build(Fence, tomllib.loads(written)["inputs"], "t") == Fence()
    assert written.count("[[inputs.posts]]\n") == 2
    assert written.count("stiffness; greater than 0 N/mm") == 2  # of a post, of the rail behind #
    assert "\n# Rails. Optional.\n# [[inputs.rails]]\n# at = 1 " in written
    assert '\n# # c = "0 N s/m"' in written


def test_other_entries_have_another_key_of_the_cache():
    case = fenced()
    one, other = (Fence(posts=(Post(at=2, k=k),)) for k in (1e3, 1e3 + 1e-6))
    assert cache.key(case, one, 1) == cache.key(case, Fence(posts=(Post(at=2, k=1e3),)), 1)
    assert cache.key(case, one, 1) != cache.key(case, other, 1)
    assert cache.key(case, one, 1) != cache.key(case, Fence(), 1)
