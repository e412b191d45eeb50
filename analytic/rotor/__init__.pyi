from analytic.rotor import clutch_uniform
from analytic.rotor.clutch import SpragCoupling
from analytic.rotor.cylinder import Cylinder
from analytic.rotor.pochhammer import bending_frequency
from analytic.rotor.shafts import UniformShaft
from analytic.rotor.stepped import SteppedShape, stepped_beam
from analytic.rotor.transfer_model import (
    Segment,
    SegmentedShaft,
    Spring,
    StationDisc,
    StationLink,
    StationSupport,
    TransferMatrixRotor,
)
from analytic.rotor.transfer_modes import (
    TransferModes,
    modes,
    natural_frequencies,
    transfer_critical_speeds,
    whirl_frequencies,
)
from analytic.rotor.transfer_response import TransferResponse, transfer_unbalance_response
from analytic.rotor.transfer_torsion import torsional_frequencies

Clutch = SpragCoupling  # its name in version 0.1
Disc = StationDisc  # its name in version 0.1
Link = StationLink  # its name in version 0.1
Modes = TransferModes  # its name in version 0.1
Response = TransferResponse  # its name in version 0.1
Rotor = TransferMatrixRotor  # its name in version 0.1
Shaft = SegmentedShaft  # its name in version 0.1
Support = StationSupport  # its name in version 0.1
critical_speeds = transfer_critical_speeds  # its name in version 0.1
unbalance_response = transfer_unbalance_response  # its name in version 0.1

__all__ = [
    "Cylinder", "Segment", "SegmentedShaft", "SpragCoupling", "Spring", "StationDisc",
    "StationLink", "StationSupport", "SteppedShape", "TransferMatrixRotor", "TransferModes",
    "TransferResponse", "UniformShaft", "bending_frequency", "clutch_uniform", "modes",
    "natural_frequencies", "stepped_beam", "torsional_frequencies", "transfer_critical_speeds",
    "transfer_unbalance_response", "whirl_frequencies",
]  # fmt: skip
