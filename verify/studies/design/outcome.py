"""Result of a design task: the search, finite-element results of the front, the chosen spring."""

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
    """Result of a design task.

    `verified` contains the finite-element results of the members of the front; it is empty if
    finite elements were not used. `chosen` is the index of the chosen member, counted from 0, or
    None if nothing is feasible. `curve` is the curve of the chosen spring by finite elements, to a
    displacement beyond U_A.
    """

    search: Search
    verified: Sequence[Verified]
    chosen: int | None
    curve: Curve | None = None

    @property
    def passed(self) -> bool:
        """Whether a spring was chosen and, if finite elements were used, passed their checks.

        The chosen spring must fit, and the stiffness of every verified member must agree.
        """
        if self.chosen is None:
            return False
        if not self.verified:
            return True
        return self.verified[self.chosen].fits and all(v.agrees for v in self.verified)

    @property
    def candidate(self) -> int:
        """Index of the chosen spring among all candidates."""
        assert self.chosen is not None
        return int(self.search.members[self.chosen])


def carry_out(
    task: Task, *, choose: int | None, use_fem: bool, drawn: bool, quiet: bool
) -> Outcome:
    """Search, verify the front, and choose member number `choose`, counted from 1.

    If `choose` is None, the first member that finite elements confirm is chosen, in the order of
    the distance to the ideal point. If they confirm no member, the first member is chosen. `drawn`
    adds the curve of the chosen spring. Raises InputError if the front has no member number
    `choose`.
    """
    found = search(task)
    members = [int(i) for i in found.members]
    if not members:
        return Outcome(found, (), None)
    if choose is not None and not 1 <= choose <= len(members):
        raise InputError(
            f"--choose must be the number of a design of the Pareto front, 1 to {len(members)}, "
            f"got {choose}"
        )
    if not use_fem:
        return Outcome(found, (), (choose or 1) - 1)
    with progress.shown(quiet=quiet) as show:

        def notify(done: int, remaining: float) -> None:
            show(progress.State(done, len(members), (f"member {done + 1}",), remaining))

        checked = verified(found.springs, found.formulas, members, task.demands, notify)
    accepted = next((k for k, v in enumerate(checked) if v.agrees and v.fits), 0)
    chosen = accepted if choose is None else choose - 1
    i, f = members[chosen], found.formulas
    if not drawn:
        return Outcome(found, checked, chosen)
    stroke = BEYOND * max(float(f.U_A[i]), float(f.U_w[i]))
    curve = compressed(found.springs, f, i, task.demands, stroke=stroke)
    return Outcome(found, checked, chosen, curve)


def chosen_file(outcome: Outcome) -> str:
    """Text of a parameter file with the chosen spring, for `freewheel check --fem`."""
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
