"""Factors L L' of symmetric, positive definite matrices by CHOLMOD's supernodal method.

cvxopt provides CHOLMOD. It returns its factor in a capsule with the structure `cholmod_factor`. The
conversion by cvxopt (`cholmod.getfactor`) destroys this structure. Therefore the last block of L is
read from the structure, whose members are the same in CHOLMOD 1.7 to 5.
"""

import ctypes
from functools import cached_property
from threading import Lock
from typing import Any

import numpy as np
from cvxopt import cholmod, matrix, spmatrix
from scipy.sparse import csc_array, csr_array

from fem.plane.geometry import Array

_OPTIONS = Lock()  # `cholmod.options` apply to the whole process
_NAME = b"CHOLMOD FACTOR D L"  # of capsules with factors of real numbers, from lower triangles
_pointer_in = ctypes.PYFUNCTYPE(ctypes.c_void_p, ctypes.py_object, ctypes.c_char_p)(
    ("PyCapsule_GetPointer", ctypes.pythonapi)
)


class Cholesky:
    """Cholesky factorisation A = L L' of a symmetric, positive definite `A` (n, n).

    Only the lower triangle is used (for a csr_array, the upper triangle). Unknowns are eliminated
    in their order; with `ordered` False, CHOLMOD chooses the order. Raises ArithmeticError if `A`
    is not positive definite.

    >>> factor = Cholesky(csc_array([[4.0, 2.0, 0.0], [2.0, 3.0, 1.0], [0.0, 1.0, 2.0]]))
    >>> factor.solve(np.array([8.0, 11.0, 8.0])).round(12)
    array([1., 2., 3.])
    >>> L = factor.last_block(2)
    >>> (L @ L.T).round(12)  # 3 - 2 * 2 / 4 is left of the 3
    array([[2., 1.],
           [1., 2.]])
    """

    def __init__(self, A: csc_array | csr_array, *, ordered: bool = True) -> None:
        self.n: int = A.shape[0]
        self._lower = spmatrix(*_lower(A), A.shape)
        order = (matrix(np.arange(self.n, dtype=np.intc)),) if ordered else ()
        with _OPTIONS:
            cholmod.options.update(supernodal=2, nmethods=len(order), postorder=not ordered)
            self._factor = cholmod.symbolic(self._lower, *order)
        self._factorise()

    def renew(self, A: csc_array | csr_array) -> None:
        """Replace the factors by those of `A`, which must have the same sorted sparsity pattern."""
        self._lower.V = _lower(A)[0]
        self._factorise()

    def _factorise(self) -> None:
        try:
            cholmod.numeric(self._lower, self._factor)
        except ArithmeticError as error:
            raise ArithmeticError(
                "the matrix is not positive definite to working precision: pivot "
                f"{error} of {self.n} is not positive"
            ) from error

    def solve(self, b: Array) -> Array:
        """Solution A^-1 b for `b` (n,) or (n, k)."""
        x = matrix(np.asarray(b, float))
        cholmod.solve(self._factor, x)
        return np.asarray(x).reshape(b.shape)

    @property
    def entries(self) -> int:
        """Number of stored entries of L, including zeros."""
        return int(self._stored.xsize)

    def last_block(self, count: int) -> Array:
        """Last block (count, count) of L; the unknowns must not have been reordered.

        The product of the block with its transpose is A condensed to the last `count` unknowns.
        """
        of, first = self._stored, self.n - count
        start, at, value_at = (
            _read(part, of.nsuper + 1, ctypes.c_ssize_t) for part in (of.super, of.pi, of.px)
        )
        row = _read(of.s, of.ssize, ctypes.c_ssize_t)
        value = _read(of.x, of.xsize, ctypes.c_double)
        block = np.zeros((count, count))
        for k in range(int(np.searchsorted(start, first, side="right")) - 1, of.nsuper):
            rows, columns = row[at[k] : at[k + 1]] - first, np.arange(*start[k : k + 2]) - first
            own = value[value_at[k] : value_at[k + 1]].reshape(columns.size, rows.size).T
            below, right = rows >= 0, columns >= 0
            block[np.ix_(rows[below], columns[right])] = own[np.ix_(below, right)]
        return np.tril(block)

    @cached_property
    def _stored(self) -> "_Stored":
        stored = _Stored.from_address(_pointer_in(self._factor, _NAME))
        kind = stored.n, stored.minor, stored.is_ll, stored.is_super, stored.itype, stored.xtype
        if kind != (self.n, self.n, 1, 1, 2, 1):  # of 64-bit indices and real numbers
            raise RuntimeError("CHOLMOD stores its factors in an unknown format")
        return stored


class _Stored(ctypes.Structure):
    """Structure `cholmod_factor` up to its field `xtype`."""

    _fields_ = (
        *((name, ctypes.c_size_t) for name in ("n", "minor")),
        *((name, ctypes.c_void_p) for name in ("Perm", "ColCount", "IPerm")),
        ("nzmax", ctypes.c_size_t),
        *((name, ctypes.c_void_p) for name in ("p", "i", "x", "z", "nz", "next", "prev")),
        *((name, ctypes.c_size_t) for name in ("nsuper", "ssize", "xsize", "csize", "esize")),
        *((name, ctypes.c_void_p) for name in ("super", "pi", "px", "s")),
        *((name, ctypes.c_int) for name in ("ordering", "is_ll", "is_super", "is_monotonic")),
        *((name, ctypes.c_int) for name in ("itype", "xtype")),
    )


def _read(address: int, size: int, kind: Any) -> Any:
    return np.ctypeslib.as_array((kind * size).from_address(address))


def _lower(A: csc_array | csr_array) -> tuple[matrix, matrix, matrix]:
    """Values, rows and columns of the lower triangle of `A`, or of A' for a csr_array."""
    columns = np.repeat(np.arange(A.shape[0], dtype=np.intc), np.diff(A.indptr))
    kept = A.indices >= columns
    rows = A.indices[kept].astype(np.intc)
    return matrix(A.data[kept]), matrix(rows), matrix(columns[kept])
