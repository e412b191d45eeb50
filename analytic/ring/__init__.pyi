from analytic.ring import lame, rotating
from analytic.ring.fourier_ring import FourierRing
from analytic.ring.loaded_race import LoadedRace
from analytic.ring.smeared import SmearedError, race_deflection, smeared_error

__all__ = [
    "FourierRing", "LoadedRace", "SmearedError", "lame", "race_deflection", "rotating",
    "smeared_error",
]  # fmt: skip
