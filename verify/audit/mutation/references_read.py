"""The second, independent method: the value of a formula is changed before checks read it.

`references_moved` changes a reference only where it is judged. Here, a value of the formulas, one
key at a time, is multiplied by 1 + p in the data of a check; all numbers that the check derives
from it change as well: tolerance, scale, expected interval. The same rows should fail by both
methods. A row that fails there and passes here hides an error of its formula; a row that no key
makes fail computes its formula from the inputs.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from verify.audit.mutation.references_moved import PERTURBATIONS, Red, red_names
from verify.core.case import Check, Context, Values


class Noted(Mapping[str, float]):
    """Values that record which of them were read; reading all of them at once is also recorded."""

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
    """The rows of a check that fail if one value of the formulas is changed.

    `red` are, for each key that is read and not zero, the names of failed rows by perturbation.
    """

    red: Mapping[str, Mapping[float, set[str]]]

    def of(self, quantity: str, key: str = "") -> Red:
        """The perturbations of `key`, or of any, at which the row fails."""
        keys = [key] if key else list(self.red)
        return frozenset(
            p for k in keys for p, names in self.red.get(k, {}).items() if quantity in names
        )


def read(check: Check, context: Context) -> Read:
    """Rows of a check with each value of the formulas that it reads changed, one at a time."""
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
    """The key of the value that a check compares; "" if there is none."""
    return str(getattr(check, "analytic", ""))
