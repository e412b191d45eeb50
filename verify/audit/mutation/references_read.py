"""The second, independent method: a formula's value changed before the checks read it.

`references_moved` moves a reference where it is judged, and nothing else. Here a value of the
formulas is multiplied by 1 + p in what a check is given, one key at a time, and whatever the check
derives from it changes too: tolerance, scale, expected interval. The same rows should fail by both
methods. A row that fails there and passes here hides an error of its formula; a row that no key
makes fail computes its formula from the inputs by itself.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from verify.audit.mutation.references_moved import PERTURBATIONS, Red, red_names
from verify.core.case import Check, Context, Values


class Noted(Mapping[str, float]):
    """Values that remember which of them were read; being asked for all of them counts as well."""

    def __init__(self, values: Values) -> None:
        self.values_, self.read = values, dict[str, None]()

    def __getitem__(self, key: str) -> float:
        self.read[key] = None
        return self.values_[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self.values_)

    def __len__(self) -> int:
        return len(self.values_)


@dataclass(frozen=True)
class Read:
    """The rows of a check that fail where one value of the formulas is changed.

    `red` has, for each key that is read and not zero, names of rows by perturbation.
    """

    red: Mapping[str, Mapping[float, set[str]]]

    def of(self, quantity: str, key: str = "") -> Red:
        """The perturbations of `key`, or of any, at which the row fails."""
        keys = [key] if key else list(self.red)
        return frozenset(
            p for k in keys for p, names in self.red.get(k, {}).items() if quantity in names
        )


def read(check: Check, context: Context) -> Read:
    """A check's rows with every value of the formulas that it reads changed, one at a time."""
    noted = Noted(context.analytic)
    check.rows(replace(context, analytic=noted))
    found = {}
    for key in noted.read:
        if context.analytic.get(key):
            found[key] = {p: _red(check, context, key, p) for p in PERTURBATIONS}
    return Read(found)


def _red(check: Check, context: Context, key: str, p: float) -> set[str]:
    changed = {**context.analytic, key: context.analytic[key] * (1 + p)}
    return red_names(check, replace(context, analytic=changed))


def own_key(check: Check) -> str:
    """The key of the value that a check compares; "" without one."""
    return str(getattr(check, "analytic", ""))
