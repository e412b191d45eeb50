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
    """An emulated machine that was run: settings in effect, and remarks on inputs."""

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
    """Summary of all machines and of the rows that differ.

    `moves` contains the largest change of each row, in descending order.
    """

    machines: tuple[Machine, ...]
    not_emulated: Mapping[str, str]
    differences: tuple[Difference, ...]
    moves: tuple[Difference, ...] = ()
    failures: Mapping[str, str] = field(default_factory=dict)
    unused: tuple[str, ...] = ()

    @property
    def first_kind(self) -> tuple[Difference, ...]:
        """Differences of status, missing or additional rows, duplicate ids, and order."""
        return tuple(d for d in self.differences if d.kind is not Kind.VALUE)

    @property
    def unexplained(self) -> tuple[Difference, ...]:
        """Differences of values for which no reason is stated."""
        return tuple(d for d in self.differences if d.kind is Kind.VALUE and not d.reason)

    @property
    def is_portable(self) -> bool:
        """Whether all machines were run completely and every difference has a reason."""
        broken = any(machine.rejected for machine in self.machines)
        return not (self.failures or broken or self.first_kind or self.unexplained)


def largest(moves: Sequence[Difference]) -> tuple[Difference, ...]:
    """Largest change of each row over the machines, in descending order."""
    worst: dict[str, Difference] = {}
    for one in moves:
        if one.row not in worst or one.move > worst[one.row].move:
            worst[one.row] = one
    return tuple(sorted(worst.values(), key=lambda d: -d.move)[:LARGEST])


def lines(summary: Summary) -> Iterator[str]:
    """Lines of the summary for a terminal.

    A row with the same difference on several machines has one line.
    """
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
    yield from (f"unused reason: {rows}" for rows in summary.unused)
    if summary.moves:
        yield "largest changes, in units of the row's tolerance:"
    yield from (f"  {d.move:9.2g}  {d.row}  ({d.variant})" for d in summary.moves)
    first, unexplained = ({d.row for d in part} for part in (summary.first_kind,
                                                             summary.unexplained))  # fmt: skip
    yield (f"{len(summary.machines)} machines: {len(first)} rows whose status differs, "
           f"{len(unexplained)} whose value changes by more than a tenth of the tolerance, "
           "or whose tolerance differs, without a reason")  # fmt: skip


def write(summary: Summary, folder: Path) -> None:
    """Write portable.json and portable.md into the folder.

    Raises OSError if a file cannot be written.
    """
    data = {"portable": summary.is_portable} | asdict(summary)
    text = json.dumps(_finite(data), ensure_ascii=False, indent=1, allow_nan=False) + "\n"
    write_whole(folder / "portable.json", lambda file: file.write(text.encode("utf-8")))
    page = "\n".join(_markdown(summary)) + "\n"
    write_whole(folder / "portable.md", lambda file: file.write(page.encode("utf-8")))


def _markdown(summary: Summary) -> Iterator[str]:
    yield "# Verdicts on different machines\n"
    yield "| machine | difference from this machine | settings in effect | cases | rows | seconds |"
    yield "|---|---|---|---|---|---|"
    for m in summary.machines:
        in_effect = _effective(m.effective)
        yield f"| {m.name} | {m.what} | {in_effect} | {m.cases} | {m.rows} | {m.seconds:.0f} |"
    yield "\n## Messages\n"
    yield from (f"- {line.strip()}" for line in lines(summary) if not line.startswith("   "))
    yield "\n## Largest changes\n"
    yield "| row | machine | change / tolerance | here | there |\n|---|---|---|---|---|"
    for d in summary.moves:
        yield f"| {d.row} | {d.variant} | {d.move:.2g} | {d.was} | {d.now} |"


def _line(one: Difference) -> str:
    """Text of a difference, equal for all machines with the same difference."""
    if one.kind is Kind.VALUE:
        does = "has another tolerance" if one.move <= LIMIT else "changes"
        words = f": {one.reason}" if one.reason else " without a reason"
        return f"{one.kind.value}: {one.row} {does}{words}"
    was, now = (text.partition(" (")[0] or "no row" for text in (one.was, one.now))
    return f"{one.kind.value}: {one.row}: {was} here, {now}"


def _worst_first(found: Sequence[Difference]) -> list[Difference]:
    """Differences sorted: differences of the first kind first, then by size."""
    return sorted(found, key=lambda d: (d.kind is Kind.VALUE, bool(d.reason), -d.move))


def _grouped(pairs: Any) -> Iterator[tuple[str, str]]:
    """Each text once, with all names that belong to it."""
    groups: dict[str, list[str]] = {}
    for text, name in pairs:
        groups.setdefault(text, []).append(name)
    return ((text, ", ".join(names)) for text, names in groups.items())


def _effective(effective: Mapping[str, Any]) -> str:
    """Settings in effect as text: "BLAS numpy Haswell, scipy Haswell, 1 thread, ..."."""
    blas = ", ".join(f"{name} {core}" for name, core in sorted(effective.get("blas", {}).items()))
    threads = max(effective.get("threads", {}).values(), default=1)
    extensions = " ".join(effective.get("numpy", ())) or "none"
    return (f"BLAS {blas}, {threads} thread{'s' * (threads > 1)}; numpy {extensions}; "
            f"numba {effective.get('numba', 'host')}")  # fmt: skip


def _finite(value: Any) -> Any:
    """`value` with numbers that are not finite as text, because JSON does not have them."""
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, Mapping):
        return {key: _finite(one) for key, one in value.items()}
    return [_finite(one) for one in value] if isinstance(value, list | tuple) else value
