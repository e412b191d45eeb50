"""Thick rings.

Any consistent units are valid, except where a docstring names SI units. Messages state SI units.
"""

from analytic.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
