"""Expected errors of Cattaneo's and Mindlin's theory (half planes) for two equal discs."""

MODEL = 2.0  # bound of that error over (a/R)²


def neglected(*, a: float, R: float) -> float:
    """Bound [1] of the relative error of every half-width, displacement and energy: 2 (a/R)².

    By symmetry, the tangential load of a disc does not change the gap, and terms odd in a/R are
    zero. There are two effects of order (a/R)². First, the circle differs from the parabola: the
    slope of the profile at the edge changes by (a/R)²/4. Second, the normal and the tangential
    kernel have even parts x² + x'², each with a factor of at most one half relative to the
    logarithm. Half-widths enter displacements and energies as squares. The sum of all effects is
    below twice (a/R)².

    >>> neglected(a=0.5, R=1.0)
    0.5
    """
    return MODEL * (a / R) ** 2
