r"""Simply supported uniform rotating shafts in closed form: whirl and critical speeds.

Mode j of a shaft of length L has the wave number k = j pi/L. In the complex coordinate r = x + i y,
the frequency w of a whirl exp(i w t) at the rotational speed W (forward if w > 0) follows from

.. math::
    EIk^4 = w^2 \rho A                                        &\quad\text{(Euler)}\\
    EIk^4 = w^2(\rho A + \rho I k^2) - 2 W w\,\rho I k^2      &\quad\text{(Rayleigh)}\\
    (Sk^2 - \rho A w^2)(S + EIk^2 + 2Ww\rho I - \rho I w^2) = S^2k^2
                                                              &\quad\text{(Timoshenko)}

with S = kappa G A. The rotary inertia per length is rho I about a diameter and 2 rho I about the
axis of the shaft.

References
----------
.. [1] S. P. Timoshenko, On the correction for shear of the differential equation for transverse
   vibrations of prismatic bars, Phil. Mag. 41 (1921) 744-746.
.. [2] G. R. Cowper, The shear coefficient in Timoshenko's beam theory, J. Appl. Mech. 33 (1966)
   335-340.
.. [3] J. R. Hutchinson, Shear coefficients for Timoshenko beam theory, J. Appl. Mech. 68 (2001)
   87-92.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Theory = Literal["euler", "rayleigh", "timoshenko"]


def cowper(*, nu: float, m: float = 0.0) -> float:
    r"""Cowper's shear coefficient [1] of a circular section with m = r_i/r_o (0 if solid).

    .. math:: \kappa = \frac{6(1+\nu)(1+m^2)^2}{(7+6\nu)(1+m^2)^2 + (20+12\nu)m^2}

    Ref. [2]. Raises ValueError unless 0 <= m < 1 and -1 < nu <= 0.5.

    >>> round(cowper(nu=0.0), 6)  # 6/7
    0.857143
    """
    _check_section(nu, m)
    b = (1 + m**2) ** 2
    return 6 * (1 + nu) * b / ((7 + 6 * nu) * b + (20 + 12 * nu) * m**2)


def hutchinson(*, nu: float, m: float = 0.0) -> float:
    r"""Hutchinson's shear coefficient [1] of a circular section with m = r_i/r_o (0 if solid).

    .. math::
        \kappa = \frac{6(1+\nu)^2(1+m^2)^2}
        {(7+12\nu+4\nu^2)(1+m^2)^2 + 4(5+6\nu+2\nu^2)m^2}

    Ref. [3], Eqs. 43 and 45, expanded. Raises ValueError unless 0 <= m < 1 and -1 < nu <= 0.5.

    >>> round(hutchinson(nu=0.5), 6)  # 13.5/14: 6 * 2.25 / (7 + 6 + 1)
    0.964286
    """
    _check_section(nu, m)
    b = (1 + m**2) ** 2
    solid, hollow = 7 + 12 * nu + 4 * nu**2, 4 * (5 + 6 * nu + 2 * nu**2)
    return 6 * (1 + nu) ** 2 * b / (solid * b + hollow * m**2)


@dataclass(frozen=True, kw_only=True)
class UniformShaft:
    """Shaft of length L, diameters d_o, d_i [length], E [stress], nu, rho [mass/volume], kappa."""

    L: float
    d_o: float
    E: float
    nu: float
    rho: float
    kappa: float
    d_i: float = 0.0

    def __post_init__(self) -> None:
        for name in ("L", "E", "rho", "kappa"):
            if not 0 < getattr(self, name) < np.inf:
                raise ValueError(f"{name} must be positive, got {name}={getattr(self, name):g}")
        if not 0 <= self.d_i < self.d_o < np.inf:
            raise ValueError(
                f"diameters of a shaft must satisfy 0 <= d_i < d_o, got d_i={self.d_i:g} m, "
                f"d_o={self.d_o:g} m"
            )
        _check_section(self.nu, 0.0)

    @property
    def A(self) -> float:
        """Area of the cross-section [length^2]."""
        return np.pi / 4 * (self.d_o**2 - self.d_i**2)

    @property
    def I(self) -> float:  # noqa: E743 - the symbol of the books
        """Second moment of area about a diameter [length^4]."""
        return np.pi / 64 * (self.d_o**4 - self.d_i**4)

    @property
    def S(self) -> float:
        """Shear stiffness kappa G A [force]."""
        return self.kappa * self.E / (2 * (1 + self.nu)) * self.A

    def whirl(self, j: int, *, Omega: float = 0.0, theory: Theory) -> tuple[float, float]:
        """Angular frequencies [1/time] of mode j at the speed Omega: forward, backward; both > 0.

        Timoshenko's upper pair, in which shear and slope oscillate in opposition, is omitted.

        >>> UniformShaft(L=np.pi, d_o=4.0, E=1.0, nu=0.3, rho=1.0, kappa=0.9).whirl(
        ...     1, theory="euler")  # sqrt(E I k^4/(rho A)) = radius of gyration, d/4
        (1.0, 1.0)
        """
        k = _wave_number(self.L, j)
        A, turn = self.rho * self.A, self.rho * self.I
        bending = self.E * self.I * k**2
        if theory == "euler":
            w = k * float(np.sqrt(bending / A))
            return w, w
        if theory == "rayleigh":
            mass, half = A + turn * k**2, Omega * turn * k**2
            root = float(np.sqrt(half**2 + mass * bending * k**2))
            return (root + half) / mass, (root - half) / mass
        return self._timoshenko(k, Omega)

    def critical_speed(self, j: int, *, theory: Theory, backward: bool = False) -> float:
        """Critical speed [1/time] of mode j, forward or backward; may be infinite.

        It is infinite if, because of gyroscopic stiffening, the whirl frequency is higher than the
        rotational speed at any rotational speed.

        >>> shaft = UniformShaft(L=np.pi, d_o=4.0, E=1.0, nu=0.3, rho=1.0, kappa=0.9)
        >>> shaft.critical_speed(1, theory="rayleigh")  # rho A = rho I k^2
        inf
        """
        k = _wave_number(self.L, j)
        A, S = self.rho * self.A, self.S
        # w = -W turns the sign of the polar term: I - 2 I forward, I + 2 I backward
        turning = self.rho * self.I * (3 if backward else -1)
        bending = self.E * self.I * k**2
        if theory == "euler":
            return k * float(np.sqrt(bending / A))
        if theory == "rayleigh":
            mass = A + turning * k**2
            return k * float(np.sqrt(bending / mass)) if mass > 0 else np.inf
        # (S k^2 - A w^2)(S + bending - turning w^2) = S^2 k^2, a quadratic in w^2
        half = (A * (S + bending) + turning * S * k**2) / 2
        square = half**2 - A * turning * S * k**2 * bending
        return float(np.sqrt(S * k**2 * bending / (half + np.sqrt(square))))

    def _timoshenko(self, k: float, Omega: float) -> tuple[float, float]:
        """Inner two of the four real roots w of the quartic, which is solved for 1/w."""
        S, bending = self.S, self.E * self.I * k**2
        u = k * float(np.sqrt(bending / (self.rho * self.A)))  # Euler's, the unit of w
        A, turn = self.rho * self.A * u**2, self.rho * self.I * u**2
        polar = 2 * Omega / u * turn
        inverse = np.roots([
            S * k**2 * bending, S * k**2 * polar, -A * (S + bending) - turn * S * k**2,
            -A * polar, A * turn,
        ]).real  # fmt: skip
        return u / float(inverse.max()), -u / float(inverse.min())


def _check_section(nu: float, m: float) -> None:
    if not -1 < nu <= 0.5:
        raise ValueError(f"Poisson's ratio must lie in -1 < nu <= 0.5, got nu={nu:g}")
    if not 0 <= m < 1:
        raise ValueError(f"a section must have 0 <= r_i/r_o < 1, got m={m:g}")


def _wave_number(L: float, j: int) -> float:
    if j != int(j) or j < 1:
        raise ValueError(f"the mode number must be an integer of at least 1, got j={j}")
    return float(j * np.pi / L)
