"""How assumed inputs are listed on the terminal."""

from collections.abc import Sequence

from verify.assumed.rules import Assumed
from verify.told import aligned


def print_assumed(assumed: Sequence[Assumed]) -> None:
    """Every assumed input with its value and source, nothing where all inputs are given."""
    if not assumed:
        return
    print("assumed, because the file does not give them")
    for line in aligned([(one.name, one.text, one.source) for one in assumed]):
        print(f"  {line}")
