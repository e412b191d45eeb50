from analytic.polyhedral import expansion, forces, torque, wedging
from analytic.polyhedral.bore_pressure import (
    StiffnessFactors,
    mean_rim_displacement,
    rim_displacement,
    stiffness_factors,
)
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.design import PolyhedralClutch
from analytic.polyhedral.locking import Locked, Roller, locked
from analytic.polyhedral.parts import PolyhedralParts
from analytic.polyhedral.sector import Sector
from analytic.polyhedral.wall_stress import bore_stress, corner_stress_factor, rim_stress

Clutch = PolyhedralClutch  # its name in version 0.1
Parts = PolyhedralParts  # its name in version 0.1

__all__ = [
    "Driven", "Locked", "PolyhedralClutch", "PolyhedralParts", "Roller", "Sector",
    "StiffnessFactors", "bore_stress", "corner_stress_factor", "expansion", "forces", "locked",
    "mean_rim_displacement", "rim_displacement", "rim_stress", "stiffness_factors", "torque",
    "wedging",
]  # fmt: skip
