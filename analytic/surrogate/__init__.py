"""Surrogates of a slow model on a box of parameters, and the search for their smallest value.

Any consistent units, unless a docstring names SI units.
"""

from analytic.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
