"""Linear shells on nine-node quadrilaterals in space.

All units must be consistent.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
