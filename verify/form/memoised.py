"""Clearing of memoised results, which would hide that the code of a function was changed."""

import gc
from functools import _lru_cache_wrapper

from verify.form import quantity

MEMOISED = ("analytic.", "fem.", "meshes.", "verify.cases.")  # packages that memoise results


def forget_memoised() -> None:
    """Clear memoised results of the project's functions, so that they are computed again."""
    for item in gc.get_objects():
        if type(item) is _lru_cache_wrapper and str(item.__module__).startswith(MEMOISED):
            item.cache_clear()
    quantity.forget()
