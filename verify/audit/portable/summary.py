"""Summary of the comparison of all machines: terminal lines, JSON and Markdown files."""

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from verify.audit.portable.compare import Difference, Kind
from verify.audit.portable.moving import LIMIT
from verify.core.files import write_whole

LARGEST = 15


@dataclass(frozen=True, kw_only=True)
class Machine:
    """A variant that was run: its settings in effect, and remarks of its cases on inputs."""

    name: str
    what: str
    effective: Mapping[str, Any]
    seconds: float
    cases: int
    rows: int
    fixed: tuple[str, ...] = ()
    rejected: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class Summary:
    """All machines and the rows that differ; `moves` has the largest move of each row, in order."""

    machines: tuple[Machine, ...]
    not_emulated: Mapping[str, str]
    differences: tuple[Difference, ...]
    moves: tuple[Difference, ...] = ()
    failures: Mapping[str, str] = field(default_factory=dict)
    unused: tuple[str, ...] = ()

    @property
    def first_kind(self) -> tuple[Difference, ...]:
        """Rows whose status differs, that only one machine has, or with equal names."""
        return tuple(d for d in self.differences if d.kind is not Kind.VALUE)

    @property
    def unexplained(self) -> tuple[Difference, ...]:
        """Rows whose value moves too far or whose tolerance differs, without a stated reason."""
        return tuple(d for d in self.differences if d.kind is Kind.VALUE and not d.reason)

    @property
    def is_portable(self) -> bool:
        """Whether every variant was run completely and no row differs without a reason."""
        broken = any(machine.rejected for machine in self.machines)
        return not (self.failures or broken or self.first_kind or self.unexplained)


def largest(moves: Sequence[Difference]) -> tuple[Difference, ...]:
    """The largest move of each row over the variants, the rows that moved most first."""
    worst: dict[str, Difference] = {}
    for one in moves:
        if one.row not in worst or one.move > worst[one.row].move:
            worst[one.row] = one
    return tuple(sorted(worst.values(), key=lambda d: -d.move)[:LARGEST])


def lines(summary: Summary) -> Iterator[str]:
    """The summary for a terminal; a row that differs in several variants has one line."""
    for machine in summary.machines:
        yield (f"{machine.name}: {machine.rows} rows of {machine.cases} cases, "
               f"{machine.seconds:.0f} s; {_effective(machine.effective)}")  # fmt: skip
        yield from (f"  inputs rejected: {rule}" for rule in machine.rejected)
    for text, names in _grouped((place, m.name) for m in summary.machines for place in m.fixed):
        yield f"not perturbed, fixed by a rule: {text} in {names}"
    yield from (f"not emulated: {name}: {why}" for name, why in summary.not_emulated.items())
    yield from (f"failed: {name}: {how}" for name, how in summary.failures.items())
    for text, names in _grouped((_line(d), d.variant) for d in _worst_first(summary.differences)):
        yield f"{text} in {names}"
    yield from (f"reason not used: {rows}" for rows in summary.unused)
    if summary.moves:
        yield "largest moves, in tolerances of the row:"
    yield from (f"  {d.move:9.2g}  {d.row}  ({d.variant})" for d in summary.moves)
    first, unexplained = ({d.row for d in part} for part in (summary.first_kind,
                                                             summary.unexplained))  # fmt: skip
    yield (f"{len(summary.machines)} machines: {len(first)} rows whose status differs, "
           f"{len(unexplained)} whose value moves by more than a tenth of the tolerance, "
           "or whose tolerance differs, without a reason")  # fmt: skip


def write(summary: Summary, folder: Path) -> None:
    """Write portable.json and portable.md into the folder; OSError if that fails."""
    data = {"portable": summary.is_portable} | asdict(summary)
    text = json.dumps(_finite(data), ensure_ascii=False, indent=1, allow_nan=False) + "\n"
    write_whole(folder / "portable.json", lambda file: file.write(text.encode("utf-8")))
    page = "\n".join(_markdown(summary)) + "\n"
    write_whole(folder / "portable.md", lambda file: file.write(page.encode("utf-8")))


def _markdown(summary: Summary) -> Iterator[str]:
    yield "# The same verdicts on every machine\n"
    yield "| machine | what differs | in effect | cases | rows | seconds |"
    yield "|---|---|---|---|---|---|"
    for m in summary.machines:
        in_effect = _effective(m.effective)
        yield f"| {m.name} | {m.what} | {in_effect} | {m.cases} | {m.rows} | {m.seconds:.0f} |"
    yield "\n## Messages\n"
    yield from (f"- {line.strip()}" for line in lines(summary) if not line.startswith("   "))
    yield "\n## What moved most\n"
    yield "| row | machine | move in tolerances | here | there |\n|---|---|---|---|---|"
    for d in summary.moves:
        yield f"| {d.row} | {d.variant} | {d.move:.2g} | {d.was} | {d.now} |"


def _line(one: Difference) -> str:
    """A difference in words, the same for all variants with the same difference."""
    if one.kind is Kind.VALUE:
        does = "has another tolerance" if one.move <= LIMIT else "moves"
        words = f": {one.reason}" if one.reason else " without a reason"
        return f"{one.kind.value}: {one.row} {does}{words}"
    was, now = (text.partition(" (")[0] or "no row" for text in (one.was, one.now))
    return f"{one.kind.value}: {one.row}: {was} here, {now}"


def _worst_first(found: Sequence[Difference]) -> list[Difference]:
    """First kind before second, then by size."""
    return sorted(found, key=lambda d: (d.kind is Kind.VALUE, bool(d.reason), -d.move))


def _grouped(pairs: Any) -> Iterator[tuple[str, str]]:
    """Each text once, with the names that it came with."""
    groups: dict[str, list[str]] = {}
    for text, name in pairs:
        groups.setdefault(text, []).append(name)
    return ((text, ", ".join(names)) for text, names in groups.items())


def _effective(effective: Mapping[str, Any]) -> str:
    """Settings in effect in one line: "BLAS numpy Haswell, scipy Haswell, 1 thread, ..."."""
    blas = ", ".join(f"{name} {core}" for name, core in sorted(effective.get("blas", {}).items()))
    threads = max(effective.get("threads", {}).values(), default=1)
    extensions = " ".join(effective.get("numpy", ())) or "none"
    return (f"BLAS {blas}, {threads} thread{'s' * (threads > 1)}; numpy {extensions}; "
            f"numba {effective.get('numba', 'host')}")  # fmt: skip


def _finite(value: Any) -> Any:
    """The same with numbers that JSON does not have as text."""
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, Mapping):
        return {key: _finite(one) for key, one in value.items()}
    return [_finite(one) for one in value] if isinstance(value, list | tuple) else value
