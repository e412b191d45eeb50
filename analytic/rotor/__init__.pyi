from analytic.rotor import clutch_uniform
from analytic.rotor.clutch import Clutch
from analytic.rotor.cylinder import Cylinder
from analytic.rotor.pochhammer import bending_frequency
from analytic.rotor.shafts import UniformShaft
from analytic.rotor.stepped import SteppedShape, stepped_beam
from analytic.rotor.transfer_model import Disc, Link, Rotor, Segment, Shaft, Spring, Support
from analytic.rotor.transfer_modes import (
    Modes,
    critical_speeds,
    modes,
    natural_frequencies,
    whirl_frequencies,
)
from analytic.rotor.transfer_response import Response, unbalance_response
from analytic.rotor.transfer_torsion import torsional_frequencies

__all__ = [
    "Clutch", "Cylinder", "Disc", "Link", "Modes", "Response", "Rotor", "Segment", "Shaft",
    "Spring", "SteppedShape", "Support", "UniformShaft", "bending_frequency", "clutch_uniform",
    "critical_speeds", "modes", "natural_frequencies", "stepped_beam", "torsional_frequencies",
    "unbalance_response", "whirl_frequencies",
]  # fmt: skip
