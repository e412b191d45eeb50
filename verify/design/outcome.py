"""What a design task came to: the search, its front by finite elements, and the chosen spring."""

from collections.abc import Sequence
from dataclasses import dataclass

from verify import progress, units
from verify.design.fem import Verified, verified
from verify.design.inputs import Task
from verify.design.search import Search, search
from verify.inputs import InputError


CHOSEN = "chosen.toml"


@dataclass(frozen=True)
class Outcome:
    """`verified` belongs to the members of the front, none without finite elements.

    `chosen` counts the members from 0, and is None where nothing is feasible.
    """

    search: Search
    verified: Sequence[Verified]
    chosen: int | None

    @property
    def passed(self) -> bool:
        """Whether something is feasible, and no finite elements of the front disagree."""
        return self.chosen is not None and all(v.agrees for v in self.verified)


def carry_out(task: Task, *, choose: int, use_fem: bool, quiet: bool) -> Outcome:
    """Search, verify the front, and choose member number `choose`, counted from 1."""
    found = search(task)
    members = [int(i) for i in found.members]
    if not members:
        return Outcome(found, (), None)
    if not 1 <= choose <= len(members):
        raise InputError(f"--choose: the front has members 1 to {len(members)}, got {choose}")
    if not use_fem:
        return Outcome(found, (), choose - 1)
    with progress.shown(quiet=quiet) as show:

        def tell(done: int, remaining: float) -> None:
            show(progress.State(done, len(members), (f"member {done + 1}",), remaining))

        checked = verified(found.springs, found.formulas, members, task.demands, tell)
    return Outcome(found, checked, choose - 1)


def chosen_file(outcome: Outcome) -> str:
    """A parameter file of the chosen spring for `freewheel check --fem`."""
    found, q = outcome.search, outcome.search.task.demands
    assert outcome.chosen is not None
    i = int(found.members[outcome.chosen])
    s = found.springs
    lengths = {"b": s.b[i], "h": q.h, "r": s.r[i], "L1": s.L1[i]}
    name = found.task.name.replace("\\", "\\\\").replace('"', '\\"')
    return "\n".join([
        f"# Member {outcome.chosen + 1} of the front that freewheel design found; to go on with:",
        f"#   freewheel check --fem {CHOSEN}",
        "",
        'case = "spring-accordion"',
        f'name = "{name}"',
        "",
        "[inputs]",
        f"n = {s.n[i]}",
        *(f'{key} = "{value * 1e3:.12g} mm"' for key, value in lengths.items()),
        f'alpha = "{s.alpha[i] / units.factor("deg"):.12g} deg"',
        f'E = "{q.E / 1e9:.12g} GPa"',
        f"nu = {q.nu!r}",
        f'F = "{q.F_w:.12g} N"',
        f'R_p = "{q.sigma / 1e6:.12g} MPa"',
        "",
    ])  # fmt: skip
