"""Rotors of coaxial shafts as beams: vibration, critical speeds and unbalance response.

SI units.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
