"""Stored results of points; a key contains all data on which formulas or reference depend.

Results of formulas and of the reference are stored separately. Each is used as long as its code is
unchanged.
"""

import hashlib
import json
from collections.abc import Mapping, Sequence
from sys import intern
from typing import Any

from verify.core.case import Portion
from verify.core.inputs import Inputs
from verify.core.store import Store
from verify.studies.sweep.point import Solution

FORMAT = 2
FORMULAS, REFERENCE = "sweep formulas", "sweep reference"  # kinds of entries


class Points:
    """Stored results of a portion of a case; `code` are the hashes of formulas and reference."""

    def __init__(
        self, store: Store, case: str, part: Portion, code: tuple[str, str], versions: str
    ) -> None:
        self.store, self.case, self.part = store, case, part
        self.stamps = {
            kind: f"{side} {versions}"
            for kind, side in zip((FORMULAS, REFERENCE), code, strict=True)
        }
        store.check()

    def key(self, inputs: Inputs) -> str:
        """Key of a point, from its inputs and the levels of the portion."""
        canonical = json.dumps(inputs.model_dump(), sort_keys=True)
        parts = (str(FORMAT), self.case, self.part.name, str(self.part.levels), canonical)
        return _hash(*parts)

    def load(self, keys: Sequence[str]) -> dict[str, Solution]:
        """Stored results of the points (key: result), without parts computed by different code."""
        sides = {kind: self._side(kind, keys) for kind in self.stamps}
        found = {}
        for key in keys:
            formulas, reference = (sides[kind].get(key) for kind in (FORMULAS, REFERENCE))
            if both := formulas or reference:
                found[key] = joined(reference, formulas) if formulas else both
        return found

    def keep(self, solved: Mapping[str, Solution]) -> None:
        """Store the results of the points: of formulas, of the reference, or of both."""
        for kind, write in ((FORMULAS, _formulas), (REFERENCE, _reference)):
            entries = {
                self._entry(kind, key): json.dumps(data).encode()
                for key, one in solved.items() if (data := write(one))
            }  # fmt: skip
            if entries:
                self.store.store(kind, self.case, entries)

    def _side(self, kind: str, keys: Sequence[str]) -> dict[str, Solution]:
        names = {self._entry(kind, key): key for key in keys}
        found = {}
        for name, content in self.store.load(kind, list(names)).items():
            try:
                found[names[name]] = _solution(json.loads(content))
            except (ValueError, TypeError, LookupError, AttributeError):
                continue
        return found

    def _entry(self, kind: str, key: str) -> str:
        return _hash(key, self.stamps[kind])


def _hash(*parts: str) -> str:
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:40]


def _formulas(one: Solution) -> dict[str, Any]:
    """Results of the formulas as a dictionary for JSON; empty if they were not computed."""
    if not (one.formulas or one.problem_formulas):
        return {}
    return {"formulas": dict(one.formulas), "problem_formulas": one.problem_formulas}


def _reference(one: Solution) -> dict[str, Any]:
    """Results of the reference as a dictionary for JSON; empty if it was not computed."""
    if not (one.h or one.problem_fe):
        return {}
    return {
        "h": list(one.h), "fe": {k: list(v) for k, v in one.fe.items()}, "u_it": dict(one.u_it),
        "problem_fe": one.problem_fe, "seconds": one.seconds,
    }  # fmt: skip


def _solution(data: Mapping[str, Any]) -> Solution:
    # all points have the same names: one of each serves them all
    return Solution(
        formulas={intern(k): float(v) for k, v in data.get("formulas", {}).items()},
        h=tuple(map(float, data.get("h", ()))),
        fe={intern(k): tuple(map(float, v)) for k, v in data.get("fe", {}).items()},
        u_it={intern(k): float(v) for k, v in data.get("u_it", {}).items()},
        problem_formulas=str(data.get("problem_formulas", "")),
        problem_fe=str(data.get("problem_fe", "")), seconds=float(data.get("seconds", 0.0)),
    )  # fmt: skip


def lacking(found: Solution | None) -> tuple[bool, bool]:
    """Whether the formulas and whether the finite elements of a point still have to be computed."""
    if found is None:
        return True, True
    return (
        not (found.formulas or found.problem_formulas),
        not (found.h or found.problem_fe),
    )


def joined(old: Solution | None, new: Solution) -> Solution:
    """Solution with the results of both solutions; those of `new` have priority."""
    if old is None:
        return new
    formulas = new if new.formulas or new.problem_formulas else old
    fe = new if new.h or new.problem_fe else old
    return Solution(
        formulas.formulas, fe.h, fe.fe, fe.u_it, formulas.problem_formulas, fe.problem_fe,
        new.seconds if fe is new else old.seconds, new.lost,
    )  # fmt: skip
