"""Clutch and rotor: closed-form stiffness, rotating shafts, exact transfer matrices.

SI units, except where a docstring states other units.
"""

from analytic.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
