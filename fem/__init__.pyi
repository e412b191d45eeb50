from fem.plots import plot
from fem.vtu import to_vtu

__all__ = ["plot", "to_vtu"]
