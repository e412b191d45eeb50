from fem.beam.curved import solve_curved_frame
from fem.beam.large import LargeFrame
from fem.beam.large_stability import CriticalPoint, critical_points, linear_buckling
from fem.beam.large_state import Path, State
from fem.beam.section import FrameSolution, Section
from fem.beam.spring import compress_spring
from fem.beam.straight import solve_frame
from fem.beam.touching import Obstacle, SelfContact
from fem.beam.touching_curve import Curve, TouchingLine, compress
from fem.beam.touching_rigid import Disc, Flat

__all__ = [
    "CriticalPoint", "Curve", "Disc", "Flat", "FrameSolution", "LargeFrame", "Obstacle", "Path",
    "Section", "SelfContact", "State", "TouchingLine", "compress", "compress_spring",
    "critical_points", "linear_buckling", "solve_curved_frame", "solve_frame",
]  # fmt: skip
