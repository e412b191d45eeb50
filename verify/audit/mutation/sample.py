"""Selection of mutants: a seeded sample, the same for everyone, or all."""

import ast
import hashlib
from collections import defaultdict, deque
from collections.abc import Collection, Iterable, Mapping, Sequence

from verify.audit.mutation.operators import Operator
from verify.audit.mutation.sites import Changed, Source, mutants, owners, source


def reached(
    modules: Iterable[str], operators: Mapping[str, Operator], functions: Collection[str]
) -> list[Changed]:
    """All mutants of the modules' functions that are called, and of constants that these read."""
    found: list[Changed] = []
    for module in modules:
        of = source(module)
        called = {name.partition(":")[2] for name in functions if name.startswith(f"{module}:")}
        found += [
            one for one in mutants(of, operators)
            if one.mutant.function in called or _is_read(one.mutant.function, of, called)
        ]  # fmt: skip
    return found


def _is_read(constant: str, of: Source, called: Collection[str]) -> bool:
    """Whether a constant is read by a called function of its module."""
    return is_constant(constant) and bool(readers(constant, of) & set(called))


def is_constant(name: str) -> bool:
    """Whether a module's constant is named, and no function or method."""
    return name.lstrip("_").isupper()


def readers(constant: str, of: Source) -> set[str]:
    """The functions of a module that read one of its constants."""
    return {
        name for name, owner in owners(of.tree)
        if isinstance(owner, ast.FunctionDef)
        and any(isinstance(n, ast.Name) and n.id == constant for n in ast.walk(owner))
    }  # fmt: skip


def sample(among: Sequence[Changed], size: int, seed: int) -> list[Changed]:
    """Mutants of each operator in turn, in an order that does not depend on other code.

    Rare faults are tried as often as frequent ones, as far as there are mutants; of several changes
    at one place, only the first in this order is used.
    """
    waiting: dict[str, deque[Changed]] = defaultdict(deque)
    for one in sorted(among, key=lambda one: _rank(one, seed)):
        waiting[one.mutant.operator].append(one)
    chosen: list[Changed] = []
    taken: set[int] = set()
    while len(chosen) < size and any(waiting.values()):
        for operator in sorted(waiting):
            queue = waiting[operator]
            while queue and id(queue[0].place.node) in taken:
                queue.popleft()
            if queue and len(chosen) < size:
                one = queue.popleft()
                taken.add(id(one.place.node))
                chosen.append(one)
    return chosen


def _rank(one: Changed, seed: int) -> str:
    return hashlib.sha256(f"{seed}:{one.mutant.id}".encode()).hexdigest()
