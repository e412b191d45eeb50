"""Accordion springs of roller clutches.

Any consistent units, unless a docstring names SI units; messages state SI units.
"""

from analytic.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
