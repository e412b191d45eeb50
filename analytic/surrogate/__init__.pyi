from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial, random_designs
from analytic.surrogate.evolution import evolve
from analytic.surrogate.found import Found
from analytic.surrogate.infill import Infilled
from analytic.surrogate.infill import infill as search_with_infill
from analytic.surrogate.kriging import Kriging
from analytic.surrogate.largest import Largest, fit_largest

__all__ = [
    "Box", "Found", "Infilled", "Kriging", "Largest", "evolve", "fit_largest", "full_factorial",
    "random_designs", "search_with_infill",
]  # fmt: skip
