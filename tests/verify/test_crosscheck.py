"""`freewheel crosscheck`: what agrees, what is outside, what is not installed, what is stale."""

import json
import re
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
from verify.studies.crosscheck.comparisons import clutches, contacts, rings
from verify.studies.crosscheck.not_compared import ALONE
from verify.studies.crosscheck.statement import CALCULIX, ROSS, SOLVERS, TAMAAS, Cross, Quantity

installed = pytest.mark.skipif(
    running.executable() is None, reason="calculix (ccx) is not installed"
)
guests = pytest.mark.skipif(
    bool(solvers.solver(TAMAAS).missing), reason="tamaas is not installed: make crosscheck"
)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Records of this test alone."""
    monkeypatch.setattr(records, "FOLDER", tmp_path / "measured")
    return tmp_path / "measured" / "crosscheck"


@pytest.fixture
def ring(monkeypatch, folder):
    """The ring of coarse cells as the only comparison."""
    monkeypatch.setattr(rings, "FINE", 1)
    (cross,) = [c for c in registry.COMPARISONS if c.id == "ring-lame, plane strain"]
    monkeypatch.setattr(registry, "COMPARISONS", (cross,))
    monkeypatch.setattr(judged, "COMPARISONS", (cross,))
    return cross


def spoiled(cross, spoil):
    """The same with `spoil` done to the text of its deck."""

    def pose():
        posed = cross.pose()

        def write(folder):
            deck = posed.write(folder)
            text = deck.read_text("ascii")
            changed = spoil(text)
            assert changed != text
            deck.write_text(changed, "ascii")
            return deck

        return replace(posed, write=write)

    return replace(cross, pose=pose)


def crosscheck(*words, out):
    return run(["crosscheck", *words, "--out", str(out)])


@installed
def test_a_ring_agrees_and_is_kept_for_this_code(ring, folder, tmp_path, capsys):
    assert crosscheck("ring-lame", out=tmp_path) == 0
    said = capsys.readouterr().out
    assert said.count("agrees") == len(ring.quantities)
    (file,) = folder.iterdir()
    assert file.name == "ring-lame-plane-strain.json"
    one = store.current(ring)
    assert one.ours["bore"] == pytest.approx(one.theirs["bore"], rel=5e-5)
    assert "cd ring-lame-plane-strain && ccx -i deck" in (tmp_path / "RERUN.txt").read_text()
    # what is kept is not solved again
    (tmp_path / ring.file / "deck.inp").unlink()
    assert "kept" not in said
    assert crosscheck("ring-lame", out=tmp_path) == 0
    assert not (tmp_path / ring.file / "deck.inp").exists()
    said = capsys.readouterr().out
    assert said.count("agrees, kept") == len(ring.quantities)
    assert f"1 of 1 problems kept from {one.date} (--again solves them again)" in said


@installed
@pytest.mark.parametrize(
    "spoil",
    [
        lambda text: text.replace(f"{206e9:.12e},", f"{1.1 * 206e9:.12e},"),
        lambda text: re.sub(r",P(\d),(\S+)", lambda m: f",P{m[1]},{float(m[2]) / 2:.12e}", text),
    ],
    ids=["E x 1.1", "load halved"],
)
def test_a_wrong_deck_is_outside(spoil, ring, folder, monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(registry, "COMPARISONS", (spoiled(ring, spoil),))
    monkeypatch.setattr(store, "code_of", lambda _cross: "")
    assert crosscheck("ring-lame", out=tmp_path) == 1
    assert (
        "outside: ring-lame, plane strain, bore displacement, plane strain"
        in capsys.readouterr().out
    )


@installed
def test_what_calculix_says_of_a_deck_that_it_refuses_is_told_and_kept(
    ring, folder, monkeypatch, tmp_path, capsys
):
    broken = spoiled(ring, lambda text: text.replace("*ELASTIC", "*NONSENSE"))
    monkeypatch.setattr(registry, "COMPARISONS", (broken,))
    monkeypatch.setattr(store, "code_of", lambda _cross: "")
    assert crosscheck("ring-lame", out=tmp_path) == 1
    said = capsys.readouterr().err
    assert "failed: ring-lame, plane strain: RuntimeError: calculix failed on deck.inp" in said
    assert "ERROR" in (tmp_path / ring.file / "deck.log").read_text()
    assert not folder.exists()


def test_absent_solvers_change_no_exit_status(folder, monkeypatch, tmp_path, capsys):
    absent = {name: solvers.Solver(name, missing="not installed: here") for name in SOLVERS}
    monkeypatch.setattr(command, "solvers", lambda: absent)
    assert crosscheck(out=tmp_path) == 0
    said = capsys.readouterr().out
    for name in SOLVERS:
        assert f"{name}: not installed: here" in said
    assert "0 comparisons of 0 problems" in said
    assert re.search(r"\d+ problems not solved, for lack of calculix and tamaas and ROSS", said)


def test_a_case_of_which_nothing_can_be_compared_is_wrong_input(monkeypatch, tmp_path, capsys):
    absent = {name: solvers.Solver(name, missing="not installed: here") for name in SOLVERS}
    monkeypatch.setattr(command, "solvers", lambda: absent)
    assert crosscheck("ring-lame", "--again", out=tmp_path) == 2
    said = capsys.readouterr()
    assert said.out == ""
    line = "ring-lame: nothing compared, calculix: not installed: here\n"
    assert said.err.endswith(line)
    assert said.err.count("\n") == 1


def test_what_is_kept_needs_no_solver_and_says_since_when(folder, monkeypatch, tmp_path, capsys):
    absent = {name: solvers.Solver(name, missing="not installed: here") for name in SOLVERS}
    monkeypatch.setattr(command, "solvers", lambda: absent)
    cross = made()
    monkeypatch.setattr(registry, "COMPARISONS", (cross,))
    monkeypatch.setattr(records, "today", lambda: "2026-01-02")
    store.keep(cross, found(cross, 1.0, 1.0))
    assert crosscheck("ring-lame", out=tmp_path) == 0
    said = capsys.readouterr().out
    assert "1 of 1 problems kept from 2026-01-02" in said
    assert "s here  s there" in said


@pytest.fixture
def compared(monkeypatch, folder):
    """A comparison whose other side answers 2.0 without a solver."""
    there = {name: solvers.Solver(name, version="1.0") for name in SOLVERS}
    monkeypatch.setattr(command, "solvers", lambda: there)
    monkeypatch.setattr(command, "compare", lambda cross, *_: found(cross, 2.0, 2.0))
    monkeypatch.setattr(registry, "COMPARISONS", (made(),))


def test_what_is_found_is_stored_for_this_code_where_that_is_wanted(compared, tmp_path, capsys):
    assert crosscheck("ring-lame", "--no-keep", out=tmp_path) == 0
    assert store.current(made()) is None
    assert crosscheck("ring-lame", out=tmp_path) == 0
    assert store.current(made()) == found(made(), 2.0, 2.0)
    assert "agrees, kept" not in capsys.readouterr().out
    assert crosscheck("ring-lame", out=tmp_path) == 0
    assert "agrees, kept" in capsys.readouterr().out
    assert crosscheck("ring-lame", "--again", out=tmp_path) == 0
    assert "agrees, kept" not in capsys.readouterr().out


def test_a_record_that_cannot_be_written_is_one_line(compared, folder, tmp_path, capsys):
    folder.parent.mkdir()
    folder.write_text("a file", "utf-8")
    assert crosscheck("ring-lame", out=tmp_path) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"freewheel: {folder / 'made.json'}: cannot be written: ")
    assert said.count("\n") == 1


def test_why_a_solver_is_absent_is_told(monkeypatch, tmp_path):
    monkeypatch.setattr(running, "executable", lambda: None)
    monkeypatch.setattr(solvers, "OWN", tmp_path)
    monkeypatch.delenv("FREEWHEEL_CROSSCHECK", raising=False)
    solvers.solver.cache_clear()
    try:
        assert solvers.solver(CALCULIX).missing == "not installed: no ccx among the programs"
        assert solvers.solver(ROSS).missing == "not installed: make crosscheck installs it"
        (tmp_path / solvers.FAILED).write_text("ERROR: no matching\n distribution\n")
        solvers.solver.cache_clear()
        assert solvers.solver(ROSS).missing == "not installed: ERROR: no matching distribution"
    finally:
        solvers.solver.cache_clear()


def test_an_environment_without_the_solver_is_told(monkeypatch):
    import sys

    monkeypatch.setenv("FREEWHEEL_CROSSCHECK", sys.executable)
    monkeypatch.setitem(solvers.MODULES, TAMAAS, "no_such_module_as_this")
    solvers.solver.cache_clear()
    try:
        assert "No module named 'no_such_module_as_this'" in solvers.solver(TAMAAS).missing
    finally:
        solvers.solver.cache_clear()


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
    (line,) = judged.judged(made(), found(made(), 2e-3, 2.01e-3))
    assert line.state is CrossState.AGREES
    assert (line.ours, line.theirs) == pytest.approx((2.0, 2.01))
    assert line.difference == pytest.approx(5e-3)
    (line,) = judged.judged(made(1e-3), found(made(), 2e-3, 2.01e-3))
    assert line.state is CrossState.OUTSIDE


def test_nan_agrees_with_nothing():
    (line,) = judged.judged(made(), replace(found(made(), 1.0, 1.0), theirs={"a": float("nan")}))
    assert line.state is CrossState.OUTSIDE


def test_other_code_makes_what_is_kept_stale(folder, monkeypatch):
    cross = made()
    monkeypatch.setattr(judged, "COMPARISONS", (cross,))
    store.keep(cross, found(cross, 1.0, 1.0))
    assert [line.state for line in judged.reported(["ring-lame"])] == [CrossState.AGREES]
    monkeypatch.setattr(store, "posing", lambda _solver, _module: "another")
    (line,) = judged.reported(["ring-lame"])
    assert line.state is CrossState.MISSING
    assert line.why.startswith("not measured for this code")
    assert judged.reported(["ring-rotation"]) == ()


def test_a_record_that_lacks_a_number_counts_for_nothing(folder):
    store.keep(made(), found(made(), 1.0, 1.0))
    assert store.current(made()).unknowns == 10
    (file,) = folder.iterdir()
    file.write_text(file.read_text("utf-8").replace("unknowns", "known"), "utf-8")
    assert store.current(made()) is None


def test_what_was_found_of_others_stays(folder):
    other = replace(made(), id="other")
    store.keep(made(), found(made(), 1.0, 1.0))
    store.keep(other, found(other, 2.0, 2.0))
    assert [store.current(one).ours["a"] for one in (made(), other)] == [1.0, 2.0]


def test_wrong_names_are_one_line(capsys, tmp_path):
    assert crosscheck("ring-lam", out=tmp_path) == 2
    assert "did you mean ring-lame?" in capsys.readouterr().err
    assert crosscheck("spring-map", out=tmp_path) == 2
    said = capsys.readouterr().err
    assert "spring-map: no second solver takes it" in said
    assert said.count("\n") == 1


def test_the_list_names_problems_and_solvers(capsys):
    assert run(["crosscheck", "--list", "rotor-step"]) == 0
    said = capsys.readouterr().out
    assert said.startswith("rotor-step")
    for name in SOLVERS:
        assert f"{name}: " in said


def test_every_subject_has_a_comparison_and_every_row_exists():
    subjects = {"ring", "polyhedral", "freewheel", "sprag", "spring", "contact", "rotor"}
    assert {cross.case.partition("-")[0] for cross in registry.COMPARISONS} == subjects
    ids = [cross.id for cross in registry.COMPARISONS]
    assert len(set(ids)) == len(ids)
    assert len({cross.file for cross in registry.COMPARISONS}) == len(ids)
    assert {cross.solver for cross in registry.COMPARISONS} == set(SOLVERS)


def test_a_case_has_a_comparison_or_says_why_it_has_none():
    compared = {cross.case for cross in registry.COMPARISONS}
    assert compared.isdisjoint(ALONE)
    assert compared | set(ALONE) == {case.id for case in CASES}
    lines = judged.reported(["ring-lame", "spring-map"])
    assert [line.case for line in lines if line.state is CrossState.ALONE] == ["spring-map"]
    assert judged.reported(["spring-map"]) == ()


def test_what_is_stored_with_the_project_agrees():
    for cross in registry.COMPARISONS:
        if record := store.RECORDS.stored(cross.file):
            states = {line.state for line in judged.judged(cross, store.read(record))}
            assert states == {CrossState.AGREES}, cross.id


def test_every_record_is_of_a_comparison():
    files = {path.stem for path in store.RECORDS.path("").parent.glob("*.json")}
    assert files <= {cross.file for cross in registry.COMPARISONS}


@installed
@pytest.mark.parametrize("problem", ["contact-sphere, flat", "polyhedral-locking, rigid roller"])
def test_contact_forces_are_those_of_the_whole_on_coarse_meshes(problem, monkeypatch, tmp_path):
    monkeypatch.setattr(contacts, "LEVEL", 1)
    (cross,) = [c for c in registry.COMPARISONS if c.id == problem]
    if cross.case == "polyhedral-locking":
        cross = replace(cross, pose=partial(clutches.locked, False, 1))
    (line,) = judged.judged(cross, command.compare(cross, solvers.solver(CALCULIX), tmp_path))
    assert line.state is CrossState.AGREES


@guests
def test_a_guest_answers_beside_its_question(tmp_path):
    (cross,) = [c for c in registry.COMPARISONS if c.id == "rotor-step"]
    line, *_ = judged.judged(cross, command.compare(cross, solvers.solver(ROSS), tmp_path))
    assert line.state is CrossState.AGREES
    question = json.loads((tmp_path / cross.file / "deck.json").read_text("utf-8"))
    for piece in question["shafts"][0]:
        piece["E"] *= 1.1
    wrong = tmp_path / "wrong.json"
    wrong.write_text(json.dumps(question), "utf-8")
    solvers.solve(ROSS, wrong)
    there = json.loads(wrong.with_suffix(".answer.json").read_text("utf-8"))
    assert there["frequencies"][0][0] > 1.01 * line.ours


@guests
def test_what_a_guest_fails_of_is_told(tmp_path):
    asked = tmp_path / "deck.json"
    asked.write_text("{}", "utf-8")
    with pytest.raises(RuntimeError, match=r"ROSS failed on deck\.json: KeyError"):
        solvers.solve(ROSS, asked)


def test_a_rotor_that_ross_has_not_is_refused():
    from fem.rotor.model import Element, Rotor, Shaft, Support
    from verify.studies.crosscheck.rotors import asked

    shaft = Shaft([Element(0.1, 0.02)] * 2)
    tilted = Rotor([shaft], supports=[Support(0, 1e8, k_tilt=1e3), Support(2, 1e8)])
    with pytest.raises(ValueError, match="holds more than x and y"):
        asked(tilted, [0.0], 2)
    with pytest.raises(ValueError, match="turns all coaxial shafts alike"):
        asked(replace(tilted, shafts=[replace(shaft, ratio=-1.0)]), [0.0], 2)


def test_unbalances_are_told_at_the_nodes_of_cut_pieces():
    from fem.rotor.model import Element, Rotor, Shaft, Support
    from verify.studies.crosscheck.rotors import asked

    pair = [Shaft([Element(0.1, 0.02)] * 2), Shaft([Element(0.1, 0.03)] * 3)]
    rotor = Rotor(pair, supports=[Support(0, 1e8), Support(6, 1e8)], refine=4)
    told = asked(rotor, [0.0], 2, {"nodes": [1, 4], "probe": 6})["unbalance"]
    assert told == {"nodes": [4, 13], "probe": 21}
