"""Warnings, readings and conditions common to formulas and comparisons of springs."""

from collections.abc import Iterator
from itertools import product
from typing import Any

from analytic.spring import frame
from analytic.spring.wide_leaf import width_factor
from verify.core.case import Context

OTHER_WIDTH = 0.005  # tolerance between the given factor and a leaf's factor


def other_width(given: float, *, h: float, leaf: float, nu: float) -> Iterator[str]:
    """Warning if `given` differs from the width factor of a leaf h [m] wide and `leaf` [m] long."""
    wide = float(width_factor(h, leaf, nu=nu))
    if abs(wide / given - 1) > OTHER_WIDTH:
        yield (
            f"width_factor = {given:.5g}, but leaves of this width and length have the width "
            f"factor {wide:.5g}: forces change by {wide / given - 1:+.1%}"
        )


def left_open(q: Any) -> Iterator[tuple[frame.Tail, frame.Head, str, dict[str, Any]]]:
    """All combinations of tail, head, arc radius and centre line that the paper's text allows."""
    tails: tuple[frame.Tail, ...] = ("arc", "mid-leaf")
    heads: tuple[frame.Head, ...] = ("free", "guided")
    paths = (("r", q.paper_path), ("r + b/2", q.path))
    return ((tail, head, *path) for tail, head, path in product(tails, heads, paths))


def stored(context: Context, name: str) -> Any:
    """Array `name`, from the first level that contains it; None if none does."""
    return next((level.arrays[name] for level in context.fem if name in level.arrays), None)


def loaded(q: Any) -> bool:
    """Whether the inputs contain a working force."""
    return q.F is not None
