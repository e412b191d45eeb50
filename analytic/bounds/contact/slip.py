"""Errors of the half planes of Cattaneo and Mindlin for two equal discs."""

MODEL = 2.0  # bound of that error over (a/R)²


def neglected(*, a: float, R: float) -> float:
    """Bound [1] of the error of a half-width, displacement or energy, as a share of it.

    By symmetry a disc's tangential load does not change the gap, and terms odd in a/R vanish. Of
    order (a/R)² are the circle against the parabola, which steepens the profile by a quarter of
    (a/R)² at the edge, and the even parts x² + x'² of the two kernels, normal and tangential, each
    with a factor of a half or less about the logarithm. Half-widths enter squared in displacements
    and energies: all of it together stays below twice (a/R)².

    >>> neglected(a=0.5, R=1.0)
    0.5
    """
    return MODEL * (a / R) ** 2
