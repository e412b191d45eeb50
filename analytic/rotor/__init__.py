"""Clutch and rotor: stiffness in closed form, rotating shafts, exact transfer matrices.

SI units, where a docstring does not say otherwise.
"""

from analytic.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
