"""Parameter files: accepted files, and one line with the error for all other files."""

import math
from dataclasses import replace

import pytest
from pydantic import model_validator

from tests.verify.ring_file import RING
from verify.answers import parameter_file
from verify.cases.ring.lame.case import LAME
from verify.core.inputs import (
    EntryError,
    InputError,
    Inputs,
    build,
    count,
    quantity,
    read_parameter_file,
    table,
    text,
)


class Post(Inputs):
    """An entry of a table."""

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


class Beam(Inputs):
    """Every kind of input once."""

    L: float = quantity("1.5 m", "mm", "L", "length", gt=0, le=1e4)
    alpha: float = quantity("30 deg", "deg", "α", "slope", ge=-90, lt=90)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.49)
    n: int = count(3, "n", "number of supports", ge=2, le=10)
    q: float = quantity("2 N/mm", "N/mm", "q", "load per length", omitted=0.0)
    F: float | None = quantity(None, "N", "", "force", omitted=None, gt=0)
    posts: tuple[Post, ...] = table((Post(at=1), Post(at=3, k=5e3)), "Posts.", required=True)
    rails: tuple[Post, ...] = table((), "Rails.")

    @model_validator(mode="after")
    def _rules(self):
        if self.q == 0 and self.F is None:
            raise ValueError("q is 0 N/mm and\nF missing: there is no load")
        places = [post.at for post in self.posts]
        for k, at in enumerate(places, start=1):
            if at in places[: k - 1]:
                raise EntryError("posts", k, f"at = {at}", "a post is there already")
        return self


POST = {"at": 2, "k": "3 kN/m"}
GOOD = {"L": "2 m", "alpha": "45°", "nu": 0.25, "n": 4, "q": "3 N/mm", "F": "5 kN",
        "posts": [POST, {"at": 4, "k": "1 N/mm", "c": "5 N s/mm"}]}  # fmt: skip


def test_values_are_read_in_si_and_displayed_and_recorded_in_their_units():
    beam = build(Beam, GOOD, "beam.toml")
    assert (beam.L, beam.nu, beam.n) == (2.0, 0.25, 4)
    assert beam.alpha == pytest.approx(math.pi / 4, rel=1e-15)
    assert (beam.q, beam.F) == (pytest.approx(3000.0), pytest.approx(5000.0))
    assert build(Beam, GOOD | {"nu": "25 %"}, "beam.toml") == beam
    assert [(post.at, post.k, post.c) for post in beam.posts] == [
        (2, pytest.approx(3e3), 0.0), (4, pytest.approx(1e3), pytest.approx(5e3)),
    ]  # fmt: skip
    assert beam.rails == ()
    shown = {i.name: (i.symbol, i.value, i.unit) for i in beam.display()[:6]}
    assert shown["alpha"] == ("α", 45.0, "deg")
    assert shown["q"] == ("q", 3.0, "N/mm")
    # an entry in a line, without what was left out
    assert [(i.symbol, i.what) for i in beam.display()[6:]] == [
        ("posts[1]", "at 2, k 3 N/mm"), ("posts[2]", "at 4, k 1 N/mm, c 5000 N s/m"),
    ]  # fmt: skip
    found = beam.record()
    assert found["L"] == {"value": 2000.0, "unit": "mm"}
    assert found["posts"][0]["k"] == {"value": 3.0, "unit": "N/mm"}
    assert "play" not in found["posts"][1]
    assert found["rails"] == []


def test_optional_inputs_may_be_left_out_and_meet_their_bounds_exactly():
    beam = build(Beam, {k: v for k, v in GOOD.items() if k != "q"}, "beam.toml")
    assert beam.q == 0.0  # not the default of 2 N/mm
    beam = build(Beam, {k: v for k, v in GOOD.items() if k != "F"}, "beam.toml")
    assert beam.F is None
    assert "F" not in {i.name for i in beam.display()}
    for key, value in (("L", "10000 mm"), ("alpha", "-90 deg"), ("nu", 0.49), ("n", 2), ("n", 10)):
        build(Beam, GOOD | {key: value}, "beam.toml")


KNOWN = "unknown key; known are L, alpha, nu, n, q, F, posts, rails"
WRONG_VALUES = [
    ({"L": "2"}, 'inputs.L: "2" has no unit: needs a length, such as "2 mm"'),
    ({"L": "2 N"}, 'inputs.L: "2 N" is not a length, such as "1.5 mm"'),
    ({"nu": math.nan}, "inputs.nu: nan is not finite"),
    ({"nu": True}, "inputs.nu: needs a number, got True"),
    ({"n": 4.0}, "inputs.n: needs a whole number, got 4.0"),
    ({"L": "10.001 m"}, "inputs.L = 10001 mm: must be at most 10000 mm"),
    ({"L": "0 mm"}, "inputs.L = 0 mm: must be greater than 0 mm"),
    ({"alpha": "-91 deg"}, "inputs.alpha = -91 deg: must be at least -90 deg"),
    ({"alpha": "90 deg"}, "inputs.alpha = 90 deg: must be less than 90 deg"),
    ({"q": "0 N/m", "F": None}, "inputs: q is 0 N/mm and F missing: there is no load"),
    ({"L": None, "n": None}, "inputs: missing L, n (L: length, in mm; n: number of supports)"),
    ({"a\n\x1b[31m\u2028b": 1}, f"inputs.a [31m b: {KNOWN}"),
    ({"posts": [POST, {"at": 3}]}, "inputs.posts[2]: missing k (k: stiffness, in N/mm)"),
    ({"posts": [POST | {"high": 3}]},
     "inputs.posts[1].high: unknown key; known are at, k, c, play, kind"),
    ({"posts": [POST | {"kind": ""}]}, "inputs.posts[1].kind: needs a printable text, got ''"),
    ({"posts": [POST | {"play": "2 m"}]}, "inputs.posts[1]: play = 2000 mm: the post falls out"),
    ({"posts": [POST, POST]}, "inputs.posts[2].at = 2: a post is there already"),
    ({"posts": 3}, "inputs.posts: needs tables [[inputs.posts]], got 3"),
    ({"posts": [POST] * 1001}, "inputs.posts: has 1001 entries, but at most 1000 are permitted"),
]  # fmt: skip


@pytest.mark.parametrize(("change", "message"), WRONG_VALUES, ids=[m for _, m in WRONG_VALUES])
def test_a_wrong_value_is_named_with_its_rule(change, message):
    raw = {k: v for k, v in (GOOD | change).items() if v is not None}
    with pytest.raises(InputError) as caught:
        build(Beam, raw, "my.toml")
    assert str(caught.value) == f"my.toml: {message}"


@pytest.mark.parametrize("key", ["L", "n"])
def test_any_wrong_value_is_refused_in_one_short_line(key):
    for value in (16**5000, "9" * 5000, "x\ny\u2028z", [[[[[[]]]]]] * 100):
        with pytest.raises(InputError) as caught:
            build(Beam, GOOD | {key: value}, "my.toml")
        printed = str(caught.value)
        assert printed.startswith(f"my.toml: inputs.{key}")
        assert printed.isprintable()
        assert len(printed) < 250


# Files

RACE = RING.replace("[inputs]", 'name = "race"\n[inputs]')


@pytest.fixture
def written(tmp_path):
    """Write a parameter file."""

    def write(content):
        path = tmp_path / "my.toml"
        path.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))
        return path

    return write


def test_a_file_gives_case_name_and_raw_inputs(written):
    raw = {"r_i": "60 mm", "r_o": "90 mm", "p_i": "100 MPa", "E": "210 GPa", "nu": 0.3}
    assert read_parameter_file(written(RACE)) == ("ring-lame", "race", raw)
    marked = "\ufeff" + RING.replace("\n", "\r\n")
    assert read_parameter_file(written(marked)) == ("ring-lame", "my", raw)


CASE = 'case: needs a line such as case = "ring-lame", '
CANNOT = "cannot be read: "
NAME = "name: needs 1 to 120 printable characters"
OUTSIDE = "unknown key; known are case, name, inputs (inputs belong under [inputs])"
WRONG_FILES = {
    "empty": ("", CASE + "it is missing"),
    "an integer too large to print": ("case = 0x1" + "0" * 5000, CASE),
    "name: two lines": ('case = "a"\nname = "two\\nlines"\n[inputs]', NAME),
    "no inputs": ('case = "a"', "inputs: needs a table [inputs], it is missing"),
    "an input outside the table": ('case = "a"\nr_i = "60 mm"', "r_i: " + OUTSIDE),
    "not UTF-8": (b"\xff\xfe", CANNOT + "not UTF-8 text (byte 0)"),
    "a key twice": (RING + "nu = 0.3\n",
                    CANNOT + "Cannot overwrite a value (at line 8, column 9)"),
    "no quotes": (RING.replace('"60 mm"', "60 mm"), CANNOT),
    "nested": ("case = " + "[" * 50_000, CANNOT + "nested too deeply"),
    "too long": ("#" * 1_000_001, "a parameter file must not be larger than 1,000,000 bytes"),
}  # fmt: skip


@pytest.mark.parametrize(("content", "message"), WRONG_FILES.values(), ids=WRONG_FILES)
def test_a_wrong_file_is_named_with_its_fault(content, message, written):
    path = written(content)
    with pytest.raises(InputError) as caught:
        read_parameter_file(path)
    printed = str(caught.value)
    assert printed.startswith(f"{path}: {message}")
    assert printed.isprintable()
    if b"60 mm\n" in path.read_bytes():  # a value without quotes is repeated with them
        assert printed.endswith('quotes are missing, r_i = "60 mm"')


def test_what_is_no_file_or_has_no_number_as_its_value_is_refused(tmp_path, written, monkeypatch):
    for path, printed in (
        (tmp_path, r"is a directory, expected a TOML file$"),
        (tmp_path / "nope.toml", r"nope\.toml: cannot be read: No such file or directory$"),
        (tmp_path / "a\0b", "embedded null"),
    ):
        with pytest.raises(InputError, match=printed):
            read_parameter_file(path)
    wild = replace(LAME, analytic=lambda q: {"u": 1.0, "stress": math.inf})
    monkeypatch.setattr(parameter_file, "find", lambda name: wild)
    with pytest.raises(InputError, match="stress"):
        parameter_file.read(written(RING))
