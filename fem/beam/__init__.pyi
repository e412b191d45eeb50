from fem.beam.curved import solve_curved_frame
from fem.beam.large import LargeFrame
from fem.beam.large_stability import CriticalPoint, critical_points, linear_buckling
from fem.beam.large_state import BeamState, Path
from fem.beam.section import FrameSolution, Section
from fem.beam.spring import compress_spring
from fem.beam.straight import solve_frame
from fem.beam.touching import BeamObstacle, SelfContact
from fem.beam.touching_curve import Curve, TouchingLine, compress
from fem.beam.touching_rigid import DiscObstacle, FlatObstacle

Disc = DiscObstacle  # its name in version 0.1
Flat = FlatObstacle  # its name in version 0.1
Obstacle = BeamObstacle  # its name in version 0.1
State = BeamState  # its name in version 0.1

__all__ = [
    "BeamObstacle", "BeamState", "CriticalPoint", "Curve", "DiscObstacle", "FlatObstacle",
    "FrameSolution", "LargeFrame", "Path", "Section", "SelfContact", "TouchingLine", "compress",
    "compress_spring", "critical_points", "linear_buckling", "solve_curved_frame", "solve_frame",
]  # fmt: skip
