"""Beams and frames on a line mesh.

Any consistent units; docstrings and messages of springs state SI units.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
