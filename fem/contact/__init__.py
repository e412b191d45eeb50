"""Contact of elastic and rigid bodies in the plane, with and without friction.

All units must be consistent. Messages state SI units.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
