"""Universal kriging: a full quadratic trend and a Gaussian process on its residuals.

The model is y(x) = f(x)'b + G(x). f are the 1 + d + d(d + 1)/2 monomials up to degree two. G has a
Matérn 5/2 correlation with one length scale per parameter. Source: Huang et al., Shock and
Vibration 2018 (the form Q + G, Eq. 20); N. Cressie, Statistics for Spatial Data, 1993, Sec. 3.4;
left-out residuals: O. Dubrule, Math. Geology 15 (1983) 687.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.linalg import cho_factor, cho_solve, solve_triangular
from scipy.spatial.distance import cdist

from analytic.contact.checks import Array
from analytic.surrogate.box import Box
from analytic.surrogate.length_scales import SHORTEST, likeliest
from analytic.surrogate.terms import NUGGET, matern, trend_terms

ROUNDING = 1e-12  # relative to the largest value: a residual below it is round-off of the trend
SETTLED = 0.02  # change of a length scale's logarithm
ROUNDS = 20  # each raises the likelihood; five were always enough so far


@dataclass(frozen=True, eq=False, kw_only=True)
class Kriging:
    """Universal kriging with given length scales, in coordinates of the unit cube."""

    box: Box
    designs: Array  # (n, d)
    values: Array  # (n,)
    length_scales: Array  # (d,)

    def __post_init__(self) -> None:
        u = self.box.to_unit(self.designs)
        if np.shape(self.values) != (len(u),) or not np.all(np.isfinite(self.values)):
            raise ValueError(f"kriging must have one finite value for each of the {len(u)} designs")
        least = trend_terms(u[:1]).shape[1] + 2
        if len(u) < least:
            raise ValueError(f"a quadratic trend requires at least {least} designs, got {len(u)}")
        twice = np.argwhere(np.triu(cdist(u, u) < 1e-9, 1))
        if len(twice):
            i, j = twice[0]
            raise ValueError(
                f"designs must be different: designs {i} and {j} are the same point, "
                f"{self.designs[i]}"
            )

    @cached_property
    def u(self) -> Array:
        return self.box.to_unit(self.designs)

    @cached_property
    def cholesky(self) -> Array:
        """Lower Cholesky factor (n, n) of the correlation matrix C of the designs."""
        C = matern(self.u, self.u, self.length_scales) + NUGGET * np.eye(len(self.u))
        return np.asarray(cho_factor(C, lower=True)[0])

    @cached_property
    def whitened_trend(self) -> tuple[Array, Array]:
        """QR factors Q (n, t), R (t, t) of L^-1 F: trend terms F, Cholesky factor L of C."""
        whitened = solve_triangular(self.cholesky, trend_terms(self.u), lower=True)
        Q, R = np.linalg.qr(whitened)
        spread = np.abs(np.diag(R))
        if spread.min() <= 1e-10 * spread.max():
            raise ValueError("the designs do not determine a quadratic trend: use more levels")
        return Q, R

    @cached_property
    def trend(self) -> Array:
        """Coefficients b (t,) of the trend by generalised least squares."""
        Q, R = self.whitened_trend
        white = solve_triangular(self.cholesky, self.values, lower=True)
        return np.asarray(solve_triangular(R, Q.T @ white))

    @cached_property
    def residual(self) -> Array:
        """Residuals (n,) of the trend."""
        return np.asarray(self.values - trend_terms(self.u) @ self.trend)

    @cached_property
    def dual(self) -> Array:
        """Weights (n,) of the correlations with the designs: C^-1 (y - F b)."""
        return np.asarray(cho_solve((self.cholesky, True), self.residual))

    @cached_property
    def variance(self) -> float:
        """Unbiased variance of the process: r'C^-1 r/(n - t)."""
        return float(self.residual @ self.dual) / (len(self.u) - len(self.trend))

    @property
    def likelihood(self) -> float:
        """Log-likelihood for these length scales, with optimal trend and variance."""
        n = len(self.u)
        spread = float(self.residual @ self.dual) / n
        return float(-n / 2 * np.log(spread) - np.sum(np.log(np.diag(self.cholesky))))

    def predict(self, x: Array) -> Array:
        """Best linear unbiased prediction (m,) at x (m, d)."""
        u = self.box.to_unit(x)
        return np.asarray(
            trend_terms(u) @ self.trend + matern(u, self.u, self.length_scales) @ self.dual
        )

    def deviation(self, x: Array) -> Array:
        """Kriging standard deviation (m,) at x (m, d), including the uncertainty of the trend."""
        u = self.box.to_unit(x)
        Q, R = self.whitened_trend
        to_designs = matern(self.u, u, self.length_scales)
        white = solve_triangular(self.cholesky, to_designs, lower=True)  # (n, m)
        of_trend = solve_triangular(R, trend_terms(u).T - R.T @ (Q.T @ white), trans=1)
        share = 1 - np.sum(white**2, axis=0) + np.sum(of_trend**2, axis=0)
        return np.asarray(np.sqrt(self.variance * np.maximum(share, 0)))

    def left_out(self) -> Array:
        """Values minus their predictions from all others, (n,) (Dubrule 1983)."""
        Q, _ = self.whitened_trend
        inverse = solve_triangular(self.cholesky, np.eye(len(self.u)), lower=True)
        across = Q.T @ inverse
        diagonal = np.sum(inverse**2, axis=0) - np.sum(across**2, axis=0)
        return np.asarray(self.dual / diagonal)  # C^-1 (y - F b) is the projected C^-1 times y

    def without(self, x: Array) -> "Kriging":
        """Kriging without the designs that are in x (m, d)."""
        kept = cdist(self.u, self.box.to_unit(x)).min(axis=1) >= 1e-9
        return Kriging(
            box=self.box,
            designs=self.designs[kept],
            values=self.values[kept],
            length_scales=self.length_scales,
        )


def fit(x: Array, y: Array, box: Box, *, seed: int = 0) -> Kriging:
    """Universal kriging of values y (n,) at x (n, d) with the most likely length scales.

    Trend and process are fitted alternately until they converge: the trend by generalised least
    squares with the present length scales, the length scales by the likelihood of the residual of
    the trend (coordinate ascent on the common likelihood). The search has three initial points, one
    of them random from `seed`; the result with the largest likelihood is returned. Raises
    ValueError if a value is not finite, there are fewer designs than trend terms + 2, or a design
    is given twice.
    """
    x, y = box.points(x), np.asarray(y, dtype=np.float64)

    def of(length_scales: Array) -> Kriging:
        return Kriging(box=box, designs=x, values=y, length_scales=length_scales)

    def better(model: Kriging) -> Kriging:
        scale = np.sqrt(model.variance)
        return of(likeliest(model.u, model.residual / scale, model.length_scales, nugget=NUGGET))

    d = box.dimension
    trend_only = of(np.full(d, SHORTEST))  # its C is a unit matrix nearly: plain least squares
    if np.max(np.abs(trend_only.residual)) <= ROUNDING * np.max(np.abs(y)):
        return trend_only  # the residual is zero and has no length scale
    random = np.exp(np.random.default_rng(seed).uniform(np.log(0.1), np.log(3), d))
    starts = [better(of(start)) for start in (np.full(d, 0.3), np.ones(d), random)]
    model = max(starts, key=lambda start: start.likelihood)
    for _ in range(ROUNDS):
        before, model = model, better(model)
        if np.max(np.abs(np.log(model.length_scales / before.length_scales))) < SETTLED:
            break
    return model
