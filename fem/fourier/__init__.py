"""Bodies of revolution under loads that vary around the axis: one (r, z) problem per harmonic.

All units must be consistent. Messages state SI units.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
