"""Length scales of a Gaussian process by maximum likelihood, with scikit-learn."""

import warnings

import numpy as np
from sklearn.exceptions import ConvergenceWarning
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import ConstantKernel, Matern, WhiteKernel

from analytic.contact.checks import Array

SHORTEST, LONGEST = 0.02, 20.0  # of the unit cube: shorter is noise to any design, longer a trend
VARIANCES = (1e-9, 1e9)  # of the process, relative to the variance at the start


def likeliest(u: Array, residual: Array, start: Array, *, nugget: float) -> Array:
    """Most likely length scales (d,) of a Matérn 5/2 process with the residual (n,) at u (n, d).

    u is in the unit cube. The search over variance and length scales is local. It begins with a
    variance of 1 and the length scales `start` (d,); therefore, the residual must be divided by its
    standard deviation.
    """
    kernel = ConstantKernel(1.0, VARIANCES) * (
        Matern(start, (SHORTEST, LONGEST), nu=2.5) + WhiteKernel(nugget, "fixed")
    )
    process = GaussianProcessRegressor(kernel, alpha=0.0)
    with warnings.catch_warnings():  # a length at its bound is a valid result: no such variation
        warnings.simplefilter("ignore", ConvergenceWarning)
        process.fit(u, residual)
    return np.asarray(np.exp(process.kernel_.theta[1:]))
