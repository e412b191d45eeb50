"""Bodies wedged between two races: states at rest, and courses through states of growing load.

SI units.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
