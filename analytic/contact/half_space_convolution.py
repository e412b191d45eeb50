"""Displacements of the cells of a half-space under given pressures; approximate inverse map.

On a grid of equal cells, the influence depends only on the distance between cells. The
displacements are a convolution, computed by fast Fourier transforms. The grid is padded with zeros
to twice its size, so that the result is not periodic. If the pressures are symmetric about the
middle of an even number of cells, cosine transforms of one half of the grid replace Fourier
transforms of the whole grid.
`scipy.fft.set_workers` sets the number of threads.

References
----------
.. [1] S. Liu, Q. Wang, G. Liu, Wear 243 (2000) 101-111: convolution by padded transforms.
.. [2] E. A. H. Vollebregt, J. Optim. Theory Appl. 162 (2014) 931-953: preconditioning by
   transforms.
"""

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from analytic.contact import love
from analytic.contact.checks import Array

Pair = tuple[int, int]
Spectrum = NDArray[np.float64] | NDArray[np.complex128]


class Convolution:
    """Influence coefficients of a grid of `shape` cells, for half the cells along `mirrored` axes.

    A mirrored axis must have an even number of cells.
    """

    def __init__(
        self,
        shape: Pair,
        *,
        cell: tuple[float, float],
        E_star: float,
        mirrored: tuple[bool, bool] = (False, False),
    ) -> None:
        self.shape, self.mirrored = shape, mirrored
        self.period: Pair = tuple(_fast(n) for n in shape)  # type: ignore[assignment]
        size = tuple(n + 1 for n in self.period)
        kernel = fft.dctn(love.table(size, cell=cell, E_star=E_star), type=1)  # type: ignore[arg-type]
        self._symbol = self._arranged(kernel)
        self._inverse = self._arranged(1 / kernel[::2, ::2])  # positive for cells of any shape

    def displacement(self, pressure: Array) -> Array:
        """Displacements [length] under `pressure`, both on the solved part of the grid."""
        return self._filter(pressure, 2, self._symbol)

    def precondition(self, displacement: Array) -> Array:
        """Approximate pressures [stress] for a periodic `displacement`; a positive definite map."""
        return self._filter(displacement, 1, self._inverse)

    def half(self, field: Array) -> Array:
        """Solved part of a field on the whole grid: half of the cells along each mirrored axis."""
        return field[tuple(np.s_[n // 2 :] if m else np.s_[:] for n, m in self._axes())]

    def whole(self, field: Array) -> Array:
        """Field on the whole grid, completed by symmetry from its solved part."""
        for axis, (_, mirrored) in enumerate(self._axes()):
            if mirrored:
                field = np.concatenate([np.flip(field, axis), field], axis)
        return field

    def _axes(self) -> list[tuple[int, bool]]:
        return list(zip(self.shape, self.mirrored, strict=True))

    def _arranged(self, kernel: Array) -> Array:
        """Transform of a kernel, with its frequencies in the order of the transformed fields."""
        x, y = (n - 1 for n in kernel.shape)
        if self.mirrored[1]:
            kernel = kernel[:, :y]
        if self.mirrored[0]:
            kernel = kernel[:x]
        elif not self.mirrored[1]:  # all frequencies, those below zero last
            kernel = np.concatenate([kernel, kernel[x - 1 : 0 : -1]])
        return np.ascontiguousarray(kernel)

    def _filter(self, field: Array, periods: int, symbol: Array) -> Array:
        """Convolution of `field` with the kernel whose transform is `symbol`.

        The field is padded with zeros to `periods` periods of the grid.
        """
        order = sorted((1, 0), key=lambda axis: not self.mirrored[axis])
        now: Spectrum = field
        for axis in order:  # zeros are padded axis by axis: what is nothing is not transformed
            n = periods * self.period[axis]
            if self.mirrored[axis]:
                now = fft.dct(now, n=n // 2, axis=axis)
            else:
                now = (fft.fft if np.iscomplexobj(now) else fft.rfft)(now, n=n, axis=axis)
        now *= symbol
        for axis in reversed(order):
            n = periods * self.period[axis]
            if self.mirrored[axis]:
                now = fft.idct(now, n=n // 2, axis=axis)
            elif axis == order[0] or self.mirrored[order[0]]:
                now = fft.irfft(now, n=n, axis=axis)
            else:
                now = fft.ifft(now, n=n, axis=axis)
            now = now[: field.shape[0]] if axis == 0 else now[:, : field.shape[1]]
        return np.asarray(now, dtype=np.float64)


def _fast(n: int) -> int:
    """Smallest even size of at least n with fast transforms."""
    return 2 * int(fft.next_fast_len(-(-n // 2), real=True))
