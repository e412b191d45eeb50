"""Bodies wedged between two races: equilibrium states, and series of states of increasing load.

SI units.
"""

from fem.public import lazily

__getattr__, __dir__ = lazily(__name__, __file__)
