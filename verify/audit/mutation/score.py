"""The score: shares of mutants that are caught, survivors with their reasons; kept as a small file.

It counts for the code that it was measured on; any change of a source makes it "not measured".
"""

import json
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from verify.audit.mutation.digest import digest
from verify.audit.mutation.groups import Group
from verify.audit.mutation.outcomes import APART, CAUGHT_BY_ROWS, By, Outcome
from verify.core.files import write_whole
from verify.core.results import Caught, MutantGroup, Survivor

PATH = Path(__file__).parents[2] / "measured" / "mutants.json"
ARGUED = Path(__file__).parent / "argued.json"
NAMES = ("formulas", "judging", "finite-elements")
REFERENCES = "references"
LEAST = 0.95  # of the mutants of formulas
STALE = "not measured for this code: freewheel mutants does it"

Score = dict[str, Any]


def argued(path: Path = ARGUED) -> dict[str, str]:
    """Why nobody can see a mutant, by its id."""
    return dict(json.loads(path.read_text("utf-8")))


def scored(group: Group, outcomes: Mapping[str, Outcome], seconds: float) -> Score:
    """The score of a group all of whose chosen mutants have an outcome."""
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


def keep(name: str, score: Any, code: str, path: Path = PATH) -> None:
    """Put a group's score into the file with the code that it counts for; others stay as they are.

    OSError where it cannot be written.
    """
    date = time.strftime("%Y-%m-%d", time.gmtime())
    data = _read(path) | {name: {**score, "code": code, "date": date}}
    write_whole(path, lambda file: file.write(_text(data).encode()))


def _text(data: Score) -> str:
    """JSON with sorted keys, two levels indented and a survivor a line: what changed shows."""

    def flat(value: Any) -> str:
        return json.dumps(value, ensure_ascii=False, allow_nan=False, sort_keys=True)

    def deep(value: Any, indent: int) -> str:
        space = " " * indent
        if isinstance(value, dict) and value and indent < 3:
            items = (f"{space} {flat(k)}: {deep(value[k], indent + 1)}" for k in sorted(value))
            return "{\n" + ",\n".join(items) + f"\n{space}}}"
        if isinstance(value, list) and any(isinstance(item, list | dict) for item in value):
            items = (f"{space} {flat(item)}" for item in value)
            return "[\n" + ",\n".join(items) + f"\n{space}]"
        return flat(value)

    return deep(data, 0) + "\n"


def _read(path: Path) -> Score:
    with suppress(OSError, ValueError):
        return dict(json.loads(path.read_text("utf-8")))
    return {}


def measured(path: Path = PATH, code: Callable[[], str] = digest) -> Caught:
    """What the file says for the present code; of a group measured on other code only its name."""
    data, now = _read(path), code()
    names = (REFERENCES, *NAMES)
    with suppress(LookupError, ValueError, TypeError, AttributeError):
        current = {name: data[name] for name in names if data.get(name, {}).get("code") == now}
        if current:
            others = [name for name in names if name not in current]
            return replace(
                caught(current), date=max(str(one["date"]) for one in current.values()),
                stale=tuple(others),
            )  # fmt: skip
    return Caught(missing=STALE)


def caught(found: Mapping[str, Any]) -> Caught:
    """What the scores of some groups say, by the groups' names."""
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
    """A group's counts."""
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
    """What the gates ask for, and references or the mutants of formulas do not give."""
    found = [
        f"{group.name}: {group.caught} of {group.tried} mutants are caught, {LEAST:.0%} are asked"
        for group in of.groups
        if group.name == "formulas" and group.caught < LEAST * group.tried
    ]
    bare = sum(one.group == "formulas" and not one.reason for one in of.survivors)
    if bare:
        found.append(f"formulas: {bare} survivors without a reason in {ARGUED.name}")
    moved = of.references.get("gate", {}).get("failures", ())
    return [*found, *(f"references: {failure}" for failure in moved)]
