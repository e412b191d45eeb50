"""Parameter files: what is read, and the one line that says what is wrong with the others."""

import contextlib
import io
import math
import os
import subprocess
import sys
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import model_validator

from verify.answers import parameter_file
from verify.answers.assumed.registry import ASSUMPTIONS
from verify.app.cli import run
from verify.cases.ring.lame.case import LAME
from verify.core.inputs import InputError, Inputs, build, count, quantity, read_parameter_file

fixed = settings(deadline=None, derandomize=True)


class Beam(Inputs):
    """Every kind of input once."""

    L: float = quantity("1.5 m", "mm", "L", "length", gt=0, le=1e4)
    alpha: float = quantity("30 deg", "deg", "α", "slope", ge=-90, lt=90)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.49)
    n: int = count(3, "n", "number of supports", ge=2, le=10)
    q: float = quantity("2 N/mm", "N/mm", "q", "load per length", omitted=0.0)
    F: float | None = quantity(None, "N", "", "force", omitted=None, gt=0)

    @model_validator(mode="after")
    def _loaded(self):
        if self.q == 0 and self.F is None:
            raise ValueError("q is 0 N/mm and\nF missing: there is no load")
        return self


GOOD = {"L": "2 m", "alpha": "45°", "nu": 0.25, "n": 4, "q": "3 N/mm", "F": "5 kN"}


# What is right.


def test_defaults_are_si_values():
    beam = Beam()
    assert beam.L == 1.5
    assert beam.alpha == pytest.approx(math.pi / 6, rel=1e-15)
    assert (beam.nu, beam.n, beam.F) == (0.3, 3, None)
    assert beam.q == pytest.approx(2000.0)


def test_a_file_s_values_are_read_in_si():
    beam = build(Beam, GOOD, "beam.toml")
    assert beam.L == 2.0
    assert beam.alpha == pytest.approx(math.pi / 4, rel=1e-15)
    assert (beam.nu, beam.n) == (0.25, 4)
    assert (beam.q, beam.F) == (pytest.approx(3000.0), pytest.approx(5000.0))


def test_what_may_be_left_out_is_what_the_model_says_and_not_the_paper_s_number():
    beam = build(Beam, {k: v for k, v in GOOD.items() if k != "q"}, "beam.toml")
    assert beam.q == 0.0  # not the default of 2 N/mm
    beam = build(Beam, {k: v for k, v in GOOD.items() if k != "F"}, "beam.toml")
    assert beam.F is None


@pytest.mark.parametrize("nu", [0, 0.25, "0.25", "25 %"], ids=str)
def test_a_number_without_unit_may_be_written_as_number_or_text(nu):
    assert build(Beam, GOOD | {"nu": nu}, "beam.toml").nu == (0 if nu == 0 else 0.25)


def test_inputs_are_shown_in_their_own_units():
    shown = {i.name: (i.symbol, i.value, i.unit) for i in build(Beam, GOOD, "b").display()}
    assert shown == {
        "L": ("L", 2000.0, "mm"), "alpha": ("α", 45.0, "deg"), "nu": ("ν", 0.25, "1"),
        "n": ("n", 4, "1"), "q": ("q", 3.0, "N/mm"), "F": ("F", 5000.0, "N"),
    }  # fmt: skip
    names = [i.name for i in build(Beam, {k: GOOD[k] for k in GOOD if k != "F"}, "b").display()]
    assert names == ["L", "alpha", "nu", "n", "q"]  # F was not given


def test_inputs_have_no_unknown_name():
    with pytest.raises(ValueError, match="Extra inputs"):
        Beam(l=1.0)


def test_inputs_do_not_change():
    with pytest.raises(ValueError, match="frozen"):
        Beam().L = 1.0


@pytest.mark.parametrize(
    ("key", "value", "accepted"),
    [
        pytest.param("L", "10 m", True, id="le: exactly"),
        pytest.param("L", "10000 mm", True, id="le: exactly, in its unit"),
        pytest.param("L", "10000.001 mm", False, id="le: beyond"),
        pytest.param("L", "1e-9 mm", True, id="gt: beyond"),
        pytest.param("L", "0 mm", False, id="gt: exactly"),
        pytest.param("alpha", "-90 deg", True, id="ge: exactly"),
        pytest.param("alpha", "-90.001 deg", False, id="ge: below"),
        pytest.param("alpha", "90 deg", False, id="lt: exactly"),
        pytest.param("alpha", "89.999 deg", True, id="lt: below"),
        pytest.param("nu", 0.49, True, id="le without unit"),
        pytest.param("nu", 0.4901, False, id="le without unit: beyond"),
        pytest.param("n", 2, True, id="count: least"),
        pytest.param("n", 1, False, id="count: too few"),
        pytest.param("n", 10, True, id="count: most"),
        pytest.param("n", 11, False, id="count: too many"),
    ],
)
def test_bounds_are_in_the_unit_of_the_input(key, value, accepted):
    try:
        build(Beam, GOOD | {key: value}, "beam.toml")
    except InputError:
        assert not accepted
    else:
        assert accepted


# What is wrong with a value: one line with file, key, rule and value.


WRONG_VALUES = {
    "no unit in the text": (
        {"L": "2"},
        'inputs.L: "2" has no unit: needs a length, such as "1.5 mm"',
    ),
    "a number for a length": ({"L": 2}, 'inputs.L: 2 has no unit: needs a length, such as "2 mm"'),
    "a float for a length": (
        {"L": 2.5},
        'inputs.L: 2.5 has no unit: needs a length, such as "2.5 mm"',
    ),
    "wrong dimension": ({"L": "2 N"}, 'inputs.L: "2 N" is not a length, such as "1.5 mm"'),
    "an angle needs one too": (
        {"alpha": "1"},
        'inputs.alpha: "1" has no unit: needs an angle, such as "1.5 deg"',
    ),
    "a unit too many": ({"nu": "0.3 mm"}, 'inputs.nu: "0.3 mm" is not a number'),
    "NaN": ({"nu": math.nan}, "inputs.nu: nan is not finite"),
    "infinite": ({"nu": math.inf}, "inputs.nu: inf is not finite"),
    "minus infinite": ({"nu": -math.inf}, "inputs.nu: -inf is not finite"),
    "text beyond floats": ({"L": "1e999 mm"}, 'inputs.L: "1e999 mm" is not finite'),
    "a truth for a number": ({"nu": True}, "inputs.nu: needs a number, got True"),
    "a truth for a length": ({"L": False}, "inputs.L: needs a length, got False"),
    "a list": ({"L": ["2 m"]}, "inputs.L: needs a length, got ['2 m']"),
    "a table": ({"L": {"m": 2}}, "inputs.L: needs a length, got {'m': 2}"),
    "a truth for a count": ({"n": True}, "inputs.n: needs a whole number, got True"),
    "a float for a count": ({"n": 4.0}, "inputs.n: needs a whole number, got 4.0"),
    "a text for a count": ({"n": "4"}, "inputs.n: needs a whole number, got '4'"),
    "a list for a count": ({"n": [4]}, "inputs.n: needs a whole number, got [4]"),
    "le": ({"L": "10.001 m"}, "inputs.L = 10001 mm: must be at most 10000 mm"),
    "gt": ({"L": "-2 m"}, "inputs.L = -2000 mm: must be greater than 0 mm"),
    "ge": ({"alpha": "-91 deg"}, "inputs.alpha = -91 deg: must be at least -90 deg"),
    "lt": ({"alpha": "91 deg"}, "inputs.alpha = 91 deg: must be less than 90 deg"),
    "no unit to show": ({"nu": 0.5}, "inputs.nu = 0.5: must be at most 0.49"),
    "count": ({"n": 11}, "inputs.n = 11: must be at most 10"),
    "rule of the model": (
        {"q": "0 N/m", "F": None},
        "inputs: q is 0 N/mm and F missing: there is no load",
    ),
    "missing": ({"L": None}, "inputs: missing L"),
    "two missing": ({"L": None, "n": None}, "inputs: missing L, n"),
    "unknown key": ({"l": "2 m"}, "inputs.l: unknown key; known are L, alpha, nu, n, q, F"),
    "control characters in a key": (
        {"a\n\x1b[31m\u2028b": 1},
        "inputs.a [31m b: unknown key; known are L, alpha, nu, n, q, F",
    ),
    "no key": ({"": 1}, "inputs.: unknown key; known are L, alpha, nu, n, q, F"),
}


@pytest.mark.parametrize(("change", "message"), WRONG_VALUES.values(), ids=WRONG_VALUES)
def test_a_wrong_value_is_named_with_its_rule(change, message):
    raw = {k: v for k, v in (GOOD | change).items() if v is not None}
    with pytest.raises(InputError) as caught:
        build(Beam, raw, "my.toml")
    assert str(caught.value) == f"my.toml: {message}"


@pytest.mark.parametrize("key", ["L", "nu", "n", "F"])
@pytest.mark.parametrize(
    "value",
    [
        pytest.param(10**400, id="1e400"),
        pytest.param(-(10**400), id="-1e400"),
        pytest.param(16**5000, id="beyond what Python prints"),
        pytest.param([16**5000], id="the same in a list"),
        pytest.param("9" * 5000, id="5000 digits in a text"),
        pytest.param("\x1b[31m\x00", id="control characters"),
        pytest.param("x\ny\u2028z", id="several lines"),
        pytest.param("é" * 500, id="long"),
        pytest.param([[[[[[]]]]]] * 100, id="nested"),
    ],
)
def test_any_wrong_value_is_refused_in_one_short_line(key, value):
    with pytest.raises(InputError) as caught:
        build(Beam, GOOD | {key: value}, "my.toml")
    said = str(caught.value)
    assert said.startswith(f"my.toml: inputs.{key}")
    assert said.isprintable()
    assert len(said) < 250


# What is wrong with a file.

RING = """case = "ring-lame"
name = "race"

[inputs]
r_i = "60 mm"
r_o = "80 mm"
p_i = "100 MPa"
E = "206 GPa"
nu = 0.3
"""


@pytest.fixture
def written(tmp_path):
    """Write a parameter file."""

    def write(content):
        path = tmp_path / "my.toml"
        path.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))
        return path

    return write


def test_a_file_gives_case_name_and_raw_inputs(written):
    case, name, raw = read_parameter_file(written(RING))
    assert (case, name) == ("ring-lame", "race")
    assert raw == {"r_i": "60 mm", "r_o": "80 mm", "p_i": "100 MPa", "E": "206 GPa", "nu": 0.3}


def test_a_file_may_begin_with_a_byte_order_mark(written):
    assert read_parameter_file(written("\ufeff" + RING))[0] == "ring-lame"


def test_a_file_without_name_is_named_after_itself(written):
    assert read_parameter_file(written(RING.replace('name = "race"', "")))[1] == "my"


CANNOT = "cannot be read: "


WRONG_FILES = {
    "empty": ("", 'case: needs a line such as case = "ring-lame", it is missing'),
    "a comment": ("# nothing", 'case: needs a line such as case = "ring-lame", it is missing'),
    "case: 3": ("case = 3", 'case: needs a line such as case = "ring-lame", got 3'),
    "case: a list": (
        'case = ["ring-lame"]',
        "case: needs a line such as case = \"ring-lame\", got ['ring-lame']",
    ),
    "name: 3": ('case = "a"\nname = 3\n[inputs]', "name: needs a text, got 3"),
    "no inputs": ('case = "a"', "inputs: needs a table [inputs], it is missing"),
    "inputs: 3": ('case = "a"\ninputs = 3', "inputs: needs a table [inputs], got 3"),
    "inputs: a list of tables": (
        'case = "a"\n[[inputs]]',
        "inputs: needs a table [inputs], got [{}]",
    ),
    "an input outside the table": (
        'case = "a"\nr_i = "60 mm"',
        "r_i: unknown key; known are case, name, inputs (inputs belong under [inputs])",
    ),
    "a table misspelt": (
        'case = "a"\n[input]',
        "input: unknown key; known are case, name, inputs (inputs belong under [inputs])",
    ),
    "control characters": (
        'case = "a"\n"x\\n\\u001B" = 1\n[inputs]',
        "x: unknown key; known are case, name, inputs",
    ),
    "not UTF-8": (
        b"\xff\xfe",
        CANNOT + "not UTF-8 text (byte 0)",
    ),
    "UTF-16": (
        RING.encode("utf-16"),
        CANNOT + "not UTF-8 text (byte 0)",
    ),
    "a key twice": (
        RING + "nu = 0.3\n",
        CANNOT + "Cannot overwrite a value (at line 10, column 9)",
    ),
    "a table twice": (
        RING + "[inputs]\n",
        CANNOT + "Cannot declare ('inputs',) twice (at line 10, column 8)",
    ),
    "no value": (RING + "a = ", CANNOT + "Invalid value (at end of document)"),
    "nested": ("case = " + "[" * 50_000, CANNOT + "nested too deeply"),
    "nested tables": ("case = " + "{a=" * 50_000, CANNOT + "nested too deeply"),
    "too long": ("#" * 1_000_001, "is larger than 1,000,000 bytes, no parameter file is"),
}


@pytest.mark.parametrize(("content", "message"), WRONG_FILES.values(), ids=WRONG_FILES)
def test_a_wrong_file_is_named_with_its_fault(content, message, written):
    path = written(content)
    with pytest.raises(InputError) as caught:
        read_parameter_file(path)
    assert str(caught.value) == f"{path}: {message}"


@pytest.mark.parametrize(
    "content",
    [
        pytest.param("case = 0x1" + "0" * 5000, id="case"),
        pytest.param('case = "a"\nname = 0x1' + "0" * 5000, id="name"),
        pytest.param('case = "a"\ninputs = 0x1' + "0" * 5000, id="inputs"),
        pytest.param("case = 1" + "0" * 5000, id="decimal"),
    ],
)
def test_integers_that_python_does_not_print_are_refused_with_the_file(content, written):
    path = written(content)
    with pytest.raises(InputError) as caught:
        read_parameter_file(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert str(caught.value).isprintable()


def test_what_is_no_file_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"is a directory, expected a TOML file$"):
        read_parameter_file(tmp_path)
    bare = tmp_path / "bare.toml"
    bare.write_text('case = "ring-lame"\n[inputs]\nr_i = 60 mm\n', "utf-8")
    with pytest.raises(InputError, match=r'quotes are missing, r_i = "60 mm"$'):
        read_parameter_file(bare)
    with pytest.raises(InputError, match=r"nope\.toml: cannot be read: No such file or directory$"):
        read_parameter_file(tmp_path / "nope.toml")
    with pytest.raises(InputError, match="embedded null"):
        read_parameter_file(tmp_path / "a\0b")
    (tmp_path / "loop.toml").symlink_to(tmp_path / "loop.toml")
    with pytest.raises(InputError, match=r"loop\.toml: cannot be read: "):
        read_parameter_file(tmp_path / "loop.toml")


# The command. Bases are whole files as key = TOML literal; a fault changes one of them.

BASES = {
    "ring-lame": {
        "r_i": '"60 mm"', "r_o": '"80 mm"', "p_i": '"100 MPa"', "E": '"206 GPa"', "nu": "0.3",
    },
    "spring-accordion": {
        "n": "10", "b": '"0.1 mm"', "h": '"56 mm"', "r": '"0.45 mm"', "L1": '"11.6 mm"',
        "alpha": '"80 deg"', "E": '"206 GPa"', "nu": "0.3",
    },
}  # fmt: skip


def rendered(case, values):
    return f'case = "{case}"\n[inputs]\n' + "".join(f"{k} = {v}\n" for k, v in values.items())


def check(path):
    """Exit status, stdout and stderr of `freewheel check path`, in this process."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = run(["check", str(path)])
    return status, out.getvalue(), err.getvalue()


def assert_refused(result, path):
    status, _, err = result
    assert status == 2
    assert err.startswith(f"freewheel: {path}: ")
    assert err.endswith("\n")
    assert err[:-1].isprintable()  # and so one line


def assert_answered(result, path):
    status, out, err = result
    if status == 2:
        assert_refused(result, path)
        return
    assert status in (0, 1, 3)
    assert err == ""
    assert "nan" not in out
    assert "inf" not in out


@pytest.mark.parametrize("case", BASES)
def test_a_good_file_is_answered(case, written):
    status, out, err = check(written(rendered(case, BASES[case])))
    assert (status, err) == (3 if case == "spring-accordion" else 0, "")  # no force is given
    assert case in out


@pytest.mark.parametrize(
    ("case", "change", "message"),
    [
        ("ring-lame", {"r_i": '"90 mm"'},
         "a ring needs r_i < r_o, got r_i = 90 mm, r_o = 80 mm"),
        ("ring-lame", {"r_i": '"80 mm"'},
         "a ring needs r_i < r_o, got r_i = 80 mm, r_o = 80 mm"),
        ("spring-accordion", {"b": '"0.5 mm"'},
         "a leaf spring needs b < r, got b = 0.5 mm, r = 0.45 mm"),
        ("spring-accordion", {"r": '"6 mm"'},
         "leaves need L1 > 2 r, got L1 = 11.6 mm, r = 6 mm"),
    ],
)  # fmt: skip
def test_what_cannot_be_built_is_refused_with_the_rule(case, change, message, written):
    path = written(rendered(case, BASES[case] | change))
    assert check(path) == (2, "", f"freewheel: {path}: inputs: {message}\n")


@pytest.mark.parametrize("value", [math.inf, -math.inf, math.nan])
def test_a_formula_that_gives_no_number_is_refused(value, written, monkeypatch):
    wild = replace(LAME, analytic=lambda q: {"u": 1.0, "stress": value})
    monkeypatch.setattr(parameter_file, "find", lambda name: wild)
    path = written(RING)
    result = check(path)
    assert_refused(result, path)
    assert "stress" in result[2]


@pytest.mark.parametrize(
    "arguments",
    [["check"], ["chek", "my.toml"], ["check", "my.toml", "--fast"], ["check", "a", "b"],
     ["check", "my.toml", "--jobs", "many"]],
    ids=" ".join,
)  # fmt: skip
def test_a_wrong_command_line_is_refused_in_one_line(arguments, capsys):
    assert run(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("freewheel: ")
    assert err[:-1].isprintable()


@st.composite
def toml_texts(draw):
    """Any text as a TOML literal."""
    text = draw(st.text(max_size=30))
    plain = "".join(c if c.isalnum() and ord(c) < 128 else f"\\U{ord(c):08X}" for c in text)
    return f'"{plain}"'


NOT_A_NUMBER = ["true", "false", "[]", "[1.0]", "{}", "{a = 1}", "1979-05-27", "07:32:00", '""']
WRONG_UNITS = ["", "s", "N m", "kg", "mm^7", "furlong", "K", "m m m m", "1"]


@st.composite
def surely_bad(draw):
    """A good file with one fault that no reading could forgive."""
    case = draw(st.sampled_from(sorted(BASES)))
    values = dict(BASES[case])
    key = draw(st.sampled_from(sorted(values)))
    number, _, unit = values[key].strip('"').partition(" ")
    fault = draw(st.sampled_from(
        ["unit", "NaN", "negative", "delete", "add", "type", "huge", "rule", "case", "syntax"]
    ))  # fmt: skip
    if fault == "unit":
        values[key] = f'"{number} {draw(st.sampled_from(WRONG_UNITS[1:]))}"'
        if unit:
            bare = draw(st.sampled_from([number, f'"{number}"']))
            values[key] = draw(st.sampled_from([values[key], bare]))
    elif fault == "NaN":
        values[key] = draw(
            st.sampled_from(["nan", "inf", "-inf", f'"nan {unit}"', f'"inf {unit}"'])
        )
    elif fault == "negative":
        key = draw(st.sampled_from([k for k in values if k != "p_i"]))  # pressures may pull
        literal = values[key]
        values[key] = f'"-{literal[1:]}' if literal.startswith('"') else f"-{literal}"
    elif fault == "delete":
        assumed = {one.name for one in ASSUMPTIONS.get(case, ())}
        del values[draw(st.sampled_from([k for k in values if k not in assumed]))]
    elif fault == "add":
        values[draw(toml_texts())] = draw(st.sampled_from(["1", '"1 mm"']))
    elif fault == "type":
        values[key] = draw(st.sampled_from(NOT_A_NUMBER) | toml_texts())
        values[key] = '"ten"' if any(c.isdigit() for c in values[key][:9]) else values[key]
    elif fault == "huge":
        digits = draw(st.sampled_from([20, 400, 4000]))
        values[key] = draw(st.sampled_from(["", "-"])) + "9" * digits
    elif fault == "rule":
        low, high = ("r_i", "r_o") if case == "ring-lame" else ("b", "r")
        values[low], values[high] = values[high], values[low]
    elif fault == "case":
        case += draw(st.sampled_from(["s", " ", "\\n", "\\u0000", "é"]))
    text = rendered(case, values)
    return text + draw(st.sampled_from(["= 1", "[", "a = b", '"', "\x00"])) * (fault == "syntax")


@st.composite
def doubtful(draw):
    """A good file with any change at all, which may leave it good."""
    case = draw(st.sampled_from(["ring-lame"] * 4 + ["spring-accordion"]))
    values = dict(BASES[case])
    key = draw(st.sampled_from(sorted(values)))
    number, _, unit = values[key].strip('"').partition(" ")
    how = draw(st.sampled_from(["size", "text", "cut", "insert", "unit"]))
    if how == "size":
        exponent = draw(st.integers(-330, 330))
        values[key] = f'"{number}e{exponent} {unit}"'
    elif how == "unit":
        other = draw(st.sampled_from(["m", "µm", "in", "kPa", "psi", "N/mm^2", "rad", "%", "°"]))
        values[key] = f'"{number} {other}"'
    elif how == "text":
        values[key] = draw(toml_texts())
    text = rendered(case, values)
    at = draw(st.integers(0, len(text)))
    if how == "cut":
        return text[:at]
    return text[:at] + draw(st.text(max_size=5)) * (how == "insert") + text[at:]


@pytest.fixture(scope="module")
def scratch(tmp_path_factory):
    return tmp_path_factory.mktemp("bad") / "my.toml"


@settings(fixed, max_examples=300)
@given(content=surely_bad())
def test_a_bad_file_is_refused_with_status_2_and_one_line(content, scratch):
    scratch.write_text(content, "utf-8", errors="replace", newline="")
    assert_refused(check(scratch), scratch)


@settings(fixed, max_examples=300)
@given(content=doubtful())
def test_a_doubtful_file_is_answered_with_finite_numbers_or_refused(content, scratch):
    scratch.write_text(content, "utf-8", errors="replace", newline="")
    assert_answered(check(scratch), scratch)


@settings(fixed, max_examples=100)
@given(content=st.binary(max_size=200))
def test_bytes_are_no_parameter_file(content, scratch):
    scratch.write_bytes(content)
    assert_refused(check(scratch), scratch)


@pytest.mark.parametrize(
    "change",
    [
        pytest.param({"E": '"1e-306 MPa"'}, id="displacements beyond floats"),
        pytest.param({"r_i": '"1e-300 mm"'}, id="squares below floats"),
        pytest.param({"r_i": '"1e-170 mm"', "r_o": '"1e-169 mm"'}, id="all squares below floats"),
        pytest.param({"p_i": '"1e-320 MPa"'}, id="a pressure of nothing"),
        pytest.param({"nu": "1" + "0" * 400}, id="an integer beyond floats"),
        pytest.param({"nu": "0x1" + "0" * 5000}, id="an integer beyond what Python prints"),
        pytest.param({"p_o": "0x1" + "0" * 5000}, id="the same where a unit is missing"),
    ],
)
def test_numbers_at_the_ends_of_floats_give_finite_answers_or_one_line(change, written):
    path = written(rendered("ring-lame", BASES["ring-lame"] | change))
    assert_answered(check(path), path)


# The same through the shell, where warnings and tracebacks would show.

SHELL = {
    "good": RING,
    "no unit": RING.replace('"60 mm"', "60"),
    "r_i > r_o": RING.replace("60 mm", "90 mm"),
    "not UTF-8": b"\xff",
    "empty": "",
    "no such case": RING.replace("ring-lame", "ring"),
}


@pytest.mark.parametrize("fault", SHELL)
def test_a_process_ends_with_status_and_line(fault, written):
    path = written(SHELL[fault])
    done = subprocess.run(
        [sys.executable, "-m", "verify", "check", str(path)],
        capture_output=True, text=True, timeout=60, check=False, env=os.environ,
    )  # fmt: skip
    if fault == "good":
        assert (done.returncode, done.stderr) == (0, "")
        assert "race" in done.stdout
    else:
        assert_refused((done.returncode, done.stdout, done.stderr), path)
        assert done.stdout == ""


@pytest.mark.parametrize("name", ["", "  ", "a\\u001b[31m", "two\\nlines", "x" * 121])
def test_a_name_is_short_and_printable(name, tmp_path):
    path = tmp_path / "a.toml"
    path.write_text(f'case = "ring-lame"\nname = "{name}"\n[inputs]\n', "utf-8")
    with pytest.raises(InputError, match=r"name: needs 1 to 120 printable characters"):
        read_parameter_file(path)
