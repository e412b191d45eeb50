r"""Approach of a steel roller and its race by Palmgren's fit.

.. math:: \delta = 3.84\cdot10^{-5}\,\frac{W^{0.9}}{l^{0.8}} \qquad (\mathrm N,\ \mathrm{mm})

The law contains neither radii nor elastic constants: it is valid for steel on steel and for the
radii of rolling bearings. In SI units, the constant is 3.84e-5 times 1e-3 (delta in m) divided by
1000^0.8 (l in m), that is 3.84 x 10^-10.4. `hertz_line_approach` contains the formulas of the half
plane.

A contact of n equal slices has this total law if each slice obeys :math:`(\delta - z)^{10/9} = s q`
with the force q of the slice and the compliance

.. math:: s = n \left(\frac{3.84\cdot10^{-5}}{l^{0.8}}\right)^{1/0.9}

References
----------
.. [1] A. Palmgren, Ball and Roller Bearing Engineering, 3rd ed., SKF Industries 1959;
   the law and its constant are cited from secondary sources.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, positive

CONSTANT = 3.84e-5 * 10**-5.4  # [m^1.8/N^0.9]; 3.84e-5 with mm


def approach(*, load: ArrayLike, length: ArrayLike) -> Array:
    """Approach delta [m] of a contact of `length` [m] under `load` [N].

    >>> round(float(approach(load=1024.0, length=32e-3)), 16)  # 3.84e-5 512/16 mm
    1.2288e-06
    """
    load, length = positive(load, "load", "N"), positive(length, "length", "m")
    return np.asarray(CONSTANT * load**0.9 / length**0.8)


def compliance(*, length: ArrayLike, slices: int) -> Array:
    """Compliance s [m^(10/9)/N] of each of the equal slices.

    >>> s = compliance(length=32e-3, slices=4)  # 4 times the whole roller's
    >>> round(float((s * 1024 / 4) ** 0.9), 16)
    1.2288e-06
    """
    if slices < 1:
        raise ValueError(f"slices must be at least 1, got {slices}")
    return np.asarray(slices * (CONSTANT / positive(length, "length", "m") ** 0.8) ** (10 / 9))
