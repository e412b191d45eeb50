"""`freewheel crosscheck`: agreement, differences, programs not installed, stale results."""

from dataclasses import replace
from functools import partial

import pytest

from verify.app.cli import run
from verify.app.crosscheck import command
from verify.cases.registry import CASES
from verify.core.results import CrossState
from verify.jobs import records
from verify.studies.crosscheck import judged, registry, solvers, store
from verify.studies.crosscheck.calculix import running
from verify.studies.crosscheck.comparisons import races, rings
from verify.studies.crosscheck.not_compared import ALONE
from verify.studies.crosscheck.statement import CALCULIX, ROSS, SOLVERS, Cross, Quantity

AGREES, OUTSIDE = CrossState.AGREES, CrossState.OUTSIDE
installed = pytest.mark.skipif(
    running.executable() is None, reason="calculix (ccx) is not installed"
)
guests = pytest.mark.skipif(
    bool(solvers.solver(ROSS).missing), reason="ROSS is not installed: make crosscheck"
)


@pytest.fixture(autouse=True)
def _own_records(tmp_path, monkeypatch, request):
    """Records of this test alone, but where those of the project are the subject."""
    if "project" not in request.node.name:
        monkeypatch.setattr(records, "FOLDER", tmp_path / "measured")


def crosscheck(*words, out):
    return run(["crosscheck", *words, "--out", str(out)])


# With the solvers, where they are installed


def softened(cross):
    """The same comparison whose deck has nine tenths of the first elastic modulus."""
    posed = cross.pose()

    def write(folder):
        deck = posed.write(folder)
        head, elastic, rest = deck.read_text("ascii").partition("*ELASTIC\n")
        modulus, _, rest = rest.partition(",")
        deck.write_text(f"{head}{elastic}{0.9 * float(modulus):.12e},{rest}", "ascii")
        return deck

    return replace(cross, pose=lambda: replace(posed, write=write))


@installed
@pytest.mark.parametrize("is_soft", [False, True], ids=["as posed", "softer"])
def test_a_ring_agrees_with_calculix_and_a_softer_one_is_outside(
    is_soft, monkeypatch, tmp_path, capsys
):
    monkeypatch.setattr(rings, "FINE", 1)  # coarse cells
    (cross,) = [c for c in registry.COMPARISONS if c.id == "ring-lame, plane strain"]
    monkeypatch.setattr(store, "code_of", lambda _cross: "")
    monkeypatch.setattr(registry, "COMPARISONS", (softened(cross) if is_soft else cross,))
    assert crosscheck("ring-lame", out=tmp_path) == is_soft
    printed = capsys.readouterr().out
    if is_soft:
        assert "outside: ring-lame, plane strain, bore displacement, plane strain" in printed
    else:
        assert printed.count("agrees") == len(cross.quantities)
        assert "cd ring-lame-plane-strain && ccx -i deck" in (tmp_path / "RERUN.txt").read_text()


ROTOR = next(cross for cross in registry.COMPARISONS if cross.id == "rotor-step")


@pytest.mark.parametrize(
    ("cross", "name"),
    [
        pytest.param(races.RACES[0], races.LOAD, marks=installed, id="a roller on a race"),
        pytest.param(ROTOR, ROTOR.quantities[0].name, marks=guests, id="frequencies of a rotor"),
    ],
)
def test_contacts_agree_with_calculix_and_rotors_with_ross(cross, name, monkeypatch, tmp_path):
    monkeypatch.setattr(races, "LEVEL", 1)
    lines = judged.judged(cross, command.compare(cross, solvers.solver(cross.solver), tmp_path))
    found = {q.name: line.state for q, line in zip(cross.quantities, lines, strict=True)}
    assert found[name] is AGREES


# Without a solver


def found(cross, ours, theirs):
    return store.found_of(cross, "1.0", {"a": ours}, {"a": theirs}, (1.0, 2.0), 10)


def made(allowed=0.01):
    """A comparison that needs no solver."""
    return Cross(
        id="made", case="ring-lame", solver=CALCULIX, what="nothing",
        pose=partial(rings.lame, "plane strain"),
        quantities=(Quantity(name="a", unit="mm", allowed=allowed, why="none"),),
    )  # fmt: skip


def test_differences_are_relative_and_numbers_in_the_quantity_s_unit():
    for allowed, theirs, state in (
        (0.01, float("nan"), OUTSIDE), (0.01, 2.01e-3, AGREES), (1e-3, 2.01e-3, OUTSIDE),
    ):  # fmt: skip
        (line,) = judged.judged(made(allowed), found(made(), 2e-3, theirs))
        assert line.state is state
    assert (line.ours, line.theirs, line.difference) == pytest.approx((2.0, 2.01, 5e-3))


def test_what_is_found_is_stored_for_this_code_unless_that_is_not_wanted(
    monkeypatch, tmp_path, capsys
):
    there = {name: solvers.Solver(name, version="1.0") for name in SOLVERS}
    monkeypatch.setattr(command, "solvers", lambda: there)
    monkeypatch.setattr(command, "compare", lambda cross, *_: found(cross, 2.0, 2.0))
    monkeypatch.setattr(registry, "COMPARISONS", (made(),))
    monkeypatch.setattr(judged, "COMPARISONS", (made(),))
    assert crosscheck("ring-lame", "--no-keep", out=tmp_path) == 0
    assert store.current(made()) is None
    assert crosscheck("ring-lame", out=tmp_path) == 0
    assert store.current(made()) == found(made(), 2.0, 2.0)
    for more, is_stored in (((), True), (("--again",), False)):
        capsys.readouterr()
        assert crosscheck("ring-lame", *more, out=tmp_path) == 0
        assert ("agrees, stored" in capsys.readouterr().out) is is_stored
    assert [line.state for line in judged.reported(["ring-lame"])] == [AGREES]
    monkeypatch.setattr(store, "posing", lambda _solver, _module: "another")  # other code
    (line,) = judged.reported(["ring-lame"])
    assert line.state is CrossState.MISSING
    assert line.why.startswith("comparison with a second solver not computed for the present code")
    assert judged.reported(["ring-rotation"]) == ()


def test_absent_solvers_change_no_exit_status_but_where_nothing_is_left(
    monkeypatch, tmp_path, capsys
):
    absent = {name: solvers.Solver(name, missing="not installed: here") for name in SOLVERS}
    monkeypatch.setattr(command, "solvers", lambda: absent)
    assert crosscheck(out=tmp_path) == 0
    printed = capsys.readouterr().out
    for name in SOLVERS:
        assert f"{name}: not installed: here" in printed
    assert "0 comparisons of 0 problems" in printed
    for name, words in (
        ("ring-lame", "ring-lame: no problem was compared: calculix: not installed: here"),
        ("spring-map", "spring-map: no second solver solves this case"),
        ("ring-lam", "did you mean ring-lame?"),
    ):
        assert crosscheck(name, "--again", out=tmp_path) == 2
        assert words in capsys.readouterr().err.splitlines()[-1]
    cross = made()
    monkeypatch.setattr(registry, "COMPARISONS", (cross,))
    monkeypatch.setattr(records, "today", lambda: "2026-01-02")
    store.keep(cross, found(cross, 1.0, 1.0))
    assert crosscheck("ring-lame", out=tmp_path) == 0
    assert "1 of 1 problems are stored results of 2026-01-02" in capsys.readouterr().out
    # the reason is that of the installation
    monkeypatch.setattr(solvers, "ENVIRONMENT", tmp_path)
    monkeypatch.delenv("FREEWHEEL_CROSSCHECK", raising=False)
    reason = solvers.solver.__wrapped__
    assert reason(ROSS).missing == "not installed: run `make crosscheck` to install it"
    (tmp_path / solvers.FAILED).write_text("ERROR: no matching\n distribution\n")
    assert reason(ROSS).missing == "not installed: ERROR: no matching distribution"


def test_a_case_has_a_stored_comparison_that_agrees_or_a_reason_for_none():
    compared = {cross.case for cross in registry.COMPARISONS}
    assert compared.isdisjoint(ALONE)
    assert compared | set(ALONE) == {case.id for case in CASES}
    assert len({cross.file for cross in registry.COMPARISONS}) == len(registry.COMPARISONS)
    lines = judged.reported(["ring-lame", "spring-map"])
    assert [line.case for line in lines if line.state is CrossState.ALONE] == ["spring-map"]
    for cross in registry.COMPARISONS:
        if record := store.RECORDS.stored(cross.file):
            states = {line.state for line in judged.judged(cross, store.read(record))}
            assert states == {AGREES}, cross.id


def test_a_rotor_that_ross_cannot_describe_is_refused():
    from fem.rotor.model import Element, Rotor, Shaft, Support
    from verify.studies.crosscheck.rotors import asked

    shaft = Shaft([Element(0.1, 0.02)] * 2)
    tilted = Rotor([shaft], supports=[Support(0, 1e8, k_tilt=1e3), Support(2, 1e8)])
    with pytest.raises(ValueError, match="bearing for ROSS must act in x and y only"):
        asked(tilted, [0.0], 2)
    with pytest.raises(ValueError, match="has one speed for all coaxial shafts"):
        asked(replace(tilted, shafts=[replace(shaft, ratio=-1.0)]), [0.0], 2)
