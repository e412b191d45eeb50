"""Bodies of revolution under loads that vary round the axis: one problem in (r, z) per harmonic.

Any consistent units; messages state SI units.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
