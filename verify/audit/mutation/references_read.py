"""Second, independent check of references: formula values are changed before checks read them.

Module `references_moved` changes a reference only where it is judged. This module multiplies one
value of the formulas at a time by 1 + p in the data of a check. All numbers that the check derives
from the value change as well: tolerance, scale, expected interval. The same rows should fail by
both methods. If a row fails by the first method but not by this one, it does not detect an error of
its formula. If a row fails for no changed value, it computes its formula from the inputs.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from verify.audit.mutation.references_moved import PERTURBATIONS, Red, red_names
from verify.core.case import Check, Context, Values


class Noted(Mapping[str, float]):
    """Mapping of values that records the keys of the values that were read."""

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
    """Rows of a check that fail if a single value of the formulas is changed.

    `red` contains the names of failed rows by key of the value and by perturbation. Values that are
    zero or not read are not included.
    """

    red: Mapping[str, Mapping[float, set[str]]]

    def of(self, quantity: str, key: str = "") -> Red:
        """Changes of the value `key` (if empty: of any value) at which the row `quantity` fails."""
        keys = [key] if key else list(self.red)
        return frozenset(
            p for k in keys for p, names in self.red.get(k, {}).items() if quantity in names
        )


def read(check: Check, context: Context) -> Read:
    """Find the rows of a check that fail if a formula value that the check reads is changed."""
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
    """Key of the value that a check compares; empty if there is none."""
    return str(getattr(check, "analytic", ""))
