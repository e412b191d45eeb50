"""Length scales of a Gaussian process by largest likelihood, the one place scikit-learn is used."""

import warnings

import numpy as np
from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import ConstantKernel, Matern, WhiteKernel

from analytic.contact.checks import Array

SHORTEST, LONGEST = 0.02, 20.0  # of the unit cube: shorter is noise to any design, longer a trend
VARIANCES = (1e-9, 1e9)  # of the process, relative to the variance at the start


def likeliest(u: Array, residual: Array, start: Array, *, nugget: float) -> Array:
    """Length scales (d,) of the Matérn 5/2 process that most likely gave the residual (n,) at u.

    u (n, d) in the unit cube. The search over variance and length scales is local, from a variance
    of 1 and the length scales `start` (d,); the residual must be divided by its deviation.
    """
    kernel = ConstantKernel(1.0, VARIANCES) * (
        Matern(start, (SHORTEST, LONGEST), nu=2.5) + WhiteKernel(nugget, "fixed")
    )
    process = GaussianProcessRegressor(kernel, alpha=0.0)
    with warnings.catch_warnings():  # a length at its bound is a valid result: no such variation
        warnings.simplefilter("ignore", ConvergenceWarning)
        process.fit(u, residual)
    return np.asarray(np.exp(process.kernel_.theta[1:]))
