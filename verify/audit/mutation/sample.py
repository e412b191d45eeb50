"""Selection of mutants: a seeded sample, equal on all machines, or all mutants."""

import ast
import hashlib
from collections import defaultdict, deque
from collections.abc import Collection, Iterable, Mapping, Sequence

from verify.audit.mutation.operators import Operator
from verify.audit.mutation.sites import Changed, Source, mutants, owners, source


def reached(
    modules: Iterable[str], operators: Mapping[str, Operator], functions: Collection[str]
) -> list[Changed]:
    """Mutants of all called functions in `modules`, and of the constants that they read."""
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
    """Whether a called function of the module reads the constant."""
    return is_constant(constant) and bool(readers(constant, of) & set(called))


def is_constant(name: str) -> bool:
    """Whether the name is that of a module constant, not of a function or method."""
    return name.lstrip("_").isupper()


def readers(constant: str, of: Source) -> set[str]:
    """Names of the functions of a module that read one of its constants."""
    return {
        name for name, owner in owners(of.tree)
        if isinstance(owner, ast.FunctionDef)
        and any(isinstance(n, ast.Name) and n.id == constant for n in ast.walk(owner))
    }  # fmt: skip


def sample(among: Sequence[Changed], size: int, seed: int) -> list[Changed]:
    """Sample of mutants, taken from each operator in turn.

    The order of the mutants depends only on their ids and on the seed. Operators with few mutants
    are selected as often as others until none of their mutants remain. Of several changes at one
    place, only the first in this order is selected.
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
