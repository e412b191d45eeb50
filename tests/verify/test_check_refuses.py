"""`check` on wrong files of users: status 2 with one line, or finite numbers."""

import contextlib
import io
import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verify.answers.parameter_file import read
from verify.app.cli import run
from verify.core.inputs import InputError

GOOD = {"r_i": '"60 mm"', "r_o": '"80 mm"', "p_i": '"100 MPa"', "E": '"206 GPa"', "nu": "0.3"}


def rendered(values, case="ring-lame"):
    lines = "".join(f"{k} = {v}\n" for k, v in values.items())
    return f'case = "{case}"\n[inputs]\n{lines}'


def check(path):
    """Exit status, stdout and stderr of `freewheel check path`, in this process."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = run(["check", str(path)])
    return status, out.getvalue(), err.getvalue()


def assert_refused(result, path):
    status, out, err = result
    assert (status, out) == (2, "")
    assert re.match(rf"freewheel: {re.escape(str(path))}(:\d+)?: ", err)
    assert err.endswith("\n")
    assert err[:-1].isprintable()  # and so one line


@pytest.mark.parametrize(
    ("case", "change", "words"),
    [
        ("ring-lame", {"r_i": '"90 mm"'}, "a ring needs r_i < r_o, got r_i = 90 mm, r_o = 80 mm"),
        ("design-spring", {}, "a task for freewheel design: freewheel design"),
        ("ring-lamé", {}, "unknown case 'ring-lamé'"),
    ],
)
def test_what_cannot_be_built_is_refused_with_the_rule(case, change, words, tmp_path):
    path = tmp_path / "my.toml"
    path.write_text(rendered(GOOD | change, case), "utf-8")
    result = check(path)
    assert_refused(result, path)
    assert words in result[2]


@st.composite
def doubtful(draw):
    """A good file with any change at all, which may leave it good."""
    values = dict(GOOD)
    key = draw(st.sampled_from(sorted(values)))
    number, _, unit = values[key].strip('"').partition(" ")
    how = draw(st.sampled_from(["size", "type", "cut", "insert", "unit"]))
    if how == "size":
        values[key] = f'"{number}e{draw(st.integers(-330, 330))} {unit}"'
    elif how == "unit":
        other = draw(st.sampled_from(["m", "µm", "in", "kPa", "psi", "N/mm^2", "rad", "%", "°"]))
        values[key] = f'"{number} {other}"'
    elif how == "type":
        values[key] = draw(st.sampled_from(["true", "[1.0]", "{a = 1}", "1979-05-27", "nan", '""']))
    text = rendered(values)
    at = draw(st.integers(0, len(text)))
    if how == "cut":
        return text[:at]
    return text[:at] + draw(st.text(max_size=5)) * (how == "insert") + text[at:]


@pytest.fixture(scope="module")
def scratch(tmp_path_factory):
    return tmp_path_factory.mktemp("bad") / "my.toml"


@settings(deadline=None, derandomize=True, max_examples=100)
@given(content=doubtful())
def test_a_doubtful_file_is_answered_with_finite_numbers_or_refused(content, scratch):
    scratch.write_text(content, "utf-8", errors="replace", newline="")
    status, out, err = result = check(scratch)
    if status == 2:
        assert_refused(result, scratch)
    else:
        assert (status in (0, 1, 3), err) == (True, "")
        assert not re.search("nan|inf", out)


def test_a_message_has_the_line_the_input_that_is_meant_and_what_is_missing(tmp_path):
    path = tmp_path / "my.toml"
    for values, words in (
        (
            GOOD | {"r_out": '"1 mm"'},
            ":8: inputs.r_out: unknown key; did you mean r_o (outer radius)?",
        ),
        (GOOD | {"r_o": "80"}, ":4: inputs.r_o: 80 has no unit"),
        (
            {k: v for k, v in GOOD.items() if k != "nu"},
            ": inputs: missing nu (nu: Poisson's ratio, symbol ν)",
        ),
    ):
        path.write_text(rendered(values), "utf-8")
        result = check(path)
        assert_refused(result, path)
        assert f"{path}{words}" in result[2]


def test_an_array_in_a_message_of_a_formula_is_one_line(tmp_path, monkeypatch):
    path = tmp_path / "my.toml"
    path.write_text(rendered(GOOD), "utf-8")

    def wrong(*_):
        raise ValueError("weights must be finite, got [[nan 1.]\n [1. nan]]")

    monkeypatch.setattr("verify.form.adapter.Formulas.__call__", wrong)
    with pytest.raises(InputError, match=re.escape("got [[nan 1.] [1. nan]]")):
        read(path)


def test_clearing_the_store_needs_a_kind(capsys):
    assert run(["store", "--clear="]) == 2
    assert capsys.readouterr().err.startswith("freewheel: --clear requires a kind of results")
