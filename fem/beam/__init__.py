"""Beams and frames on a line mesh.

All units must be consistent. Docstrings and messages about springs state SI units.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
