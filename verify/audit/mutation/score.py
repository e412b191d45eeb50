"""Score of each group: share of detected mutants, and undetected mutants with reasons.

The score is valid for the code on which it was measured. After any change of a source file, it is
reported as not measured.
"""

import json
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from verify.audit.mutation.digest import digest
from verify.audit.mutation.groups import Group
from verify.audit.mutation.outcomes import APART, CAUGHT_BY_ROWS, By, Outcome
from verify.core.results import Caught, MutantGroup, Survivor
from verify.jobs.records import Record, Records

RECORDS = Records("mutants")
ARGUED = Path(__file__).parent / "argued.json"
NAMES = ("formulas", "judging", "finite-elements")
REFERENCES = "references"
LEAST = 0.95  # of the mutants of formulas
STALE = "score of mutants not computed for the present code: run `freewheel mutants`"

Score = dict[str, Any]


def argued(path: Path = ARGUED) -> dict[str, str]:
    """Reasons why mutants cannot be detected (id of the mutant: reason)."""
    return dict(json.loads(path.read_text("utf-8")))


def scored(group: Group, outcomes: Mapping[str, Outcome], seconds: float) -> Score:
    """Score of a group in which all selected mutants have an outcome."""
    mine = [(one.mutant, outcomes[one.mutant.id]) for one in group.chosen]
    operators: dict[str, Counter[str]] = defaultdict(Counter)
    for mutant, outcome in mine:
        operators[mutant.operator][outcome.by.value] += 1
    return {
        "all": len(group.all),
        "seconds": round(seconds),
        "operators": {name: dict(sorted(counts.items())) for name, counts in operators.items()},
        "survivors": sorted(
            [mutant.id, mutant.number, mutant.before, mutant.after]
            for mutant, outcome in mine if outcome.by is By.NOTHING
        ),
    }  # fmt: skip


def keep(name: str, score: Score, code: str) -> None:
    """Store the score of a group with the code for which it is valid.

    Raises OSError if the record cannot be written.
    """
    in_order = json.loads(json.dumps(score, sort_keys=True))  # a diff shows what changed
    RECORDS.keep(name, {"code": code}, in_order)


def measured(code: Callable[[], str] = digest) -> Caught:
    """Scores valid for the present code; groups that were measured on other code are only named."""
    made_by = {"code": code()}
    names = (REFERENCES, *NAMES)
    records = {name: RECORDS.current(name, made_by, partial(_readable, name)) for name in names}
    current = {name: record for name, record in records.items() if record is not None}
    if not current:
        return Caught(missing=STALE)
    return replace(
        caught({name: record.content for name, record in current.items()}),
        date=max(record.date for record in current.values()),
        stale=tuple(name for name in names if name not in current),
    )


def latest(code: Callable[[], str] = digest) -> Caught:
    """Scores of all groups as stored, which are partly or all of earlier code; `stale` names those.

    Without any stored score, the result of `measured`.
    """
    found = measured(code)
    stored = {name: record for name in (REFERENCES, *NAMES) if (record := _stored(name))}
    if not stored:
        return found
    return replace(
        caught({name: record.content for name, record in stored.items()}),
        date=max(record.date for record in stored.values()),
        stale=(REFERENCES, *NAMES) if found.missing else found.stale,
    )


def _stored(name: str) -> Record | None:
    """Stored score of a group for any code; None if there is no valid record."""
    record = RECORDS.stored(name)
    try:
        return record and _readable(name, record)
    except (ValueError, LookupError, TypeError, AttributeError):
        return None


def _readable(name: str, record: Record) -> Record:
    """The record of a group's score.

    Raises LookupError, TypeError, ValueError or AttributeError if it contains no valid score.
    """
    caught({name: dict(record.content)})
    return record


def caught(found: Mapping[str, Any]) -> Caught:
    """Data for reports (counts, undetected mutants, references) from the stored scores by group."""
    reasons = argued()
    return Caught(
        groups=tuple(group_of(name, found[name]) for name in NAMES if name in found),
        survivors=tuple(
            _survivor(name, one, reasons)
            for name in NAMES if name in found for one in found[name]["survivors"]
        ),
        references=found.get(REFERENCES, {}),
    )  # fmt: skip


def group_of(name: str, score: Mapping[str, Any]) -> MutantGroup:
    """Counts of a group."""
    counts: Counter[str] = Counter()
    for of_operator in score["operators"].values():
        counts.update(of_operator)
    rows, apart = (_sum(counts, names) for names in (CAUGHT_BY_ROWS, APART))
    return MutantGroup(
        name=name, all=int(score["all"]), tried=sum(counts.values()) - apart, rows=rows,
        tests=counts[By.TESTS], survived=counts[By.NOTHING], apart=apart,
    )  # fmt: skip


def _sum(counts: Counter[str], names: Iterable[By]) -> int:
    return sum(counts[name] for name in names)


def _survivor(group: str, one: Sequence[Any], reasons: Mapping[str, str]) -> Survivor:
    key, number, before, after = one
    module, function, operator, *_ = key.split(":")
    return Survivor(
        group=group,
        where=f"{module}.{function}",
        line=number,
        operator=operator,
        before=before,
        after=after,
        reason=reasons.get(key, ""),
    )


def complaints(of: Caught) -> list[str]:
    """Unmet requirements on references and on mutants of formulas, one line each."""
    found = [
        f"{group.name}: {group.caught} of {group.tried} mutants are detected, {LEAST:.0%} required"
        for group in of.groups
        if group.name == "formulas" and group.caught < LEAST * group.tried
    ]
    bare = sum(one.group == "formulas" and not one.reason for one in of.survivors)
    if bare:
        found.append(f"formulas: {bare} undetected mutants without a reason in {ARGUED.name}")
    moved = of.references.get("gate", {}).get("failures", ())
    return [*found, *(f"references: {failure}" for failure in moved)]
