from analytic.polyhedral import expansion, forces, torque, wedging
from analytic.polyhedral.bore_pressure import (
    StiffnessFactors,
    mean_rim_displacement,
    rim_displacement,
    stiffness_factors,
)
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.design import Clutch
from analytic.polyhedral.locking import Locked, Roller, locked
from analytic.polyhedral.parts import Parts
from analytic.polyhedral.sector import Sector
from analytic.polyhedral.wall_stress import bore_stress, corner_stress_factor, rim_stress

__all__ = [
    "Clutch", "Driven", "Locked", "Parts", "Roller", "Sector", "StiffnessFactors",
    "bore_stress", "corner_stress_factor", "expansion", "forces", "locked",
    "mean_rim_displacement", "rim_displacement", "rim_stress", "stiffness_factors", "torque",
    "wedging",
]  # fmt: skip
