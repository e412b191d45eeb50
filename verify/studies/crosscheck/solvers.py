"""Second solvers: whether they are installed, and how they solve an input file (deck)."""

import json
import os
import subprocess
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from verify.core.virtual_environment import FAILED
from verify.studies.crosscheck.calculix import running
from verify.studies.crosscheck.statement import CALCULIX, ROSS, SOLVERS, TAMAAS

ROOT = Path(__file__).parents[3]
ENVIRONMENT = ROOT / ".venv-crosscheck"  # the environment of tamaas and ROSS
GUESTS = Path(__file__).parent / "external"
SCRIPTS = {TAMAAS: "tamaas_press.py", ROSS: "ross_rotor.py"}
MODULES = {TAMAAS: "tamaas", ROSS: "ross"}
ENOUGH = 60.0  # s for a module to print its version
LONG = 300.0  # s for a deck
RERUN = {
    CALCULIX: "ccx -i {stem}",
    TAMAAS: "{python} {script} {name} {answer}",
    ROSS: "{python} {script} {name} {answer}",
}


@dataclass(frozen=True)
class Solver:
    """A solver with its version; if it is not installed, `missing` states the reason."""

    name: str
    version: str = ""
    missing: str = ""


def solvers() -> dict[str, Solver]:
    """All second solvers (name: solver)."""
    return {name: solver(name) for name in SOLVERS}


@cache
def solver(name: str) -> Solver:
    if name == CALCULIX:
        if running.executable() is None:
            return Solver(name, missing="not installed: the program ccx was not found")
        return Solver(name, running.version())
    return _module(name)


def _module(name: str) -> Solver:
    python = interpreter()
    if python is None:
        why = _failed() or "run `make crosscheck` to install it"
        return Solver(name, missing=f"not installed: {why}")
    module = MODULES[name]
    words = [str(python), "-c", f"import {module}; print({module}.__version__)"]
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=ENOUGH)  # noqa: S603
    except (OSError, subprocess.TimeoutExpired) as error:
        return Solver(name, missing=f"not installed: {error}")
    if done.returncode:
        last = (done.stderr.strip().splitlines() or ["it does not start"])[-1]
        return Solver(name, missing=f"not installed: {_failed() or last}")
    return Solver(name, done.stdout.strip())


def _failed() -> str:
    """Reason why `make crosscheck` could not install the solvers, in one line; empty if unknown."""
    if os.environ.get("FREEWHEEL_CROSSCHECK"):
        return ""
    failed = ENVIRONMENT / FAILED
    return " ".join(failed.read_text("utf-8").split()) if failed.exists() else ""


def interpreter() -> Path | None:
    """Python interpreter of the solvers' environment, or None.

    The environment variable FREEWHEEL_CROSSCHECK can give another interpreter.
    """
    named = os.environ.get("FREEWHEEL_CROSSCHECK")
    python = Path(named) if named else ENVIRONMENT / "bin" / "python"
    return python if python.exists() else None


def solve(name: str, deck: Path, limit: float = LONG) -> float:
    """Solve a deck, store the results in its folder, and return the solution time [s].

    The time excludes the start of an interpreter. Raises RuntimeError with the last output of the
    solver if it fails or exceeds the `limit` in seconds.
    """
    if name == CALCULIX:
        return running.run_deck(deck, limit=limit).wall
    answer, python = deck.with_suffix(".answer.json"), interpreter()
    words = [str(python), str(GUESTS / SCRIPTS[name]), str(deck), str(answer)]
    answer.unlink(missing_ok=True)
    try:
        done = subprocess.run(  # noqa: S603
            words, capture_output=True, text=True, check=False, timeout=limit,
            env=os.environ | {"OMP_NUM_THREADS": "1", "PYTHONPATH": ""},
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise RuntimeError(f"{name} exceeded the limit of {limit:g} s on {deck.name}") from None
    deck.with_suffix(".log").write_text(done.stdout + done.stderr, "utf-8")
    if done.returncode or not answer.exists():
        last = (done.stderr.strip().splitlines() or ["no answer"])[-1]
        raise RuntimeError(f"{name} failed on {deck.name}: {last}")
    return float(json.loads(answer.read_text("utf-8"))["seconds"])


def rerun(name: str, deck: Path) -> str:
    """Command that solves a deck again, for use in the folder of the deck."""
    script = os.path.relpath(GUESTS / SCRIPTS[name], deck.parent) if name in SCRIPTS else ""
    python = interpreter() or ENVIRONMENT / "bin" / "python"
    return RERUN[name].format(
        stem=deck.stem, name=deck.name, answer=deck.with_suffix(".answer.json").name,
        script=script, python=os.path.relpath(python, deck.parent),
    )  # fmt: skip
