"""Surrogates of a slow model on a box of parameters, and the search for their minimum.

Any consistent units are valid, except where a docstring names SI units.
"""

from analytic.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
