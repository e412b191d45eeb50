"""Result of a design task: the search, its front by finite elements, and the chosen spring."""

from collections.abc import Sequence
from dataclasses import dataclass

from verify.core import progress, units
from verify.core.inputs import InputError
from verify.studies.design.compressed import Curve, compressed
from verify.studies.design.fem import Verified, verified
from verify.studies.design.inputs import Task
from verify.studies.design.search import Search, search

CHOSEN = "chosen.toml"
BEYOND = 1.15  # compression of the selected spring, relative to U_A


@dataclass(frozen=True)
class Outcome:
    """`verified` belongs to the members of the front, none without finite elements.

    `chosen` counts the members from 0, and is None if nothing is feasible; `curve` is the
    chosen spring's by finite elements, to a displacement beyond U_A.
    """

    search: Search
    verified: Sequence[Verified]
    chosen: int | None
    curve: Curve | None = None

    @property
    def passed(self) -> bool:
        """A candidate is feasible; finite elements confirm the formula and the chosen spring."""
        if self.chosen is None:
            return False
        if not self.verified:
            return True
        return self.verified[self.chosen].fits and all(v.agrees for v in self.verified)

    @property
    def candidate(self) -> int:
        """The chosen spring among all candidates."""
        assert self.chosen is not None
        return int(self.search.members[self.chosen])


def carry_out(
    task: Task, *, choose: int | None, use_fem: bool, drawn: bool, quiet: bool
) -> Outcome:
    """Search, verify the front, and choose member number `choose`, counted from 1.

    By default, it is the first member that finite elements confirm, in the order of the distance to
    the ideal point; if they confirm none, the first member. `drawn` adds its curve.
    """
    found = search(task)
    members = [int(i) for i in found.members]
    if not members:
        return Outcome(found, (), None)
    if choose is not None and not 1 <= choose <= len(members):
        raise InputError(f"--choose: the front has members 1 to {len(members)}, got {choose}")
    if not use_fem:
        return Outcome(found, (), (choose or 1) - 1)
    with progress.shown(quiet=quiet) as show:

        def tell(done: int, remaining: float) -> None:
            show(progress.State(done, len(members), (f"member {done + 1}",), remaining))

        checked = verified(found.springs, found.formulas, members, task.demands, tell)
    accepted = next((k for k, v in enumerate(checked) if v.agrees and v.fits), 0)
    chosen = accepted if choose is None else choose - 1
    i, f = members[chosen], found.formulas
    if not drawn:
        return Outcome(found, checked, chosen)
    stroke = BEYOND * max(float(f.U_A[i]), float(f.U_w[i]))
    curve = compressed(found.springs, f, i, task.demands, stroke=stroke)
    return Outcome(found, checked, chosen, curve)


def chosen_file(outcome: Outcome) -> str:
    """A parameter file of the chosen spring for `freewheel check --fem`."""
    found, q = outcome.search, outcome.search.task.demands
    i, s = outcome.candidate, found.springs
    lengths = {"b": s.b[i], "h": q.h, "r": s.r[i], "L1": s.L1[i]}
    name = found.task.name.replace("\\", "\\\\").replace('"', '\\"')
    return "\n".join([
        f"# Member {(outcome.chosen or 0) + 1} of the front of a design task. Next step:",
        f"#   freewheel check --fem {CHOSEN}",
        "",
        'case = "spring-stages"',
        f'name = "{name}"',
        "",
        "[inputs]",
        f"n = {s.n[i]}",
        *(f'{key} = "{value * 1e3:.12g} mm"' for key, value in lengths.items()),
        f'alpha = "{s.alpha[i] / units.factor("deg"):.12g} deg"',
        f'E = "{q.E / 1e9:.12g} GPa"',
        f"nu = {q.nu!r}",
        f"width_factor = {found.formulas.f[i]:.6g}",
        f'head = "{q.head}"',
        f'tail = "{q.tail}"',
        f'F = "{q.F_w:.12g} N"',
        "",
    ])  # fmt: skip
