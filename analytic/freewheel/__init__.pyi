from analytic.freewheel.clutch import Clutch, Material
from analytic.freewheel.course import Course, follow
from analytic.freewheel.criterion import (
    largest_axial_load,
    required_friction,
    required_friction_of_ratio,
    safety,
    traffic_light,
)
from analytic.freewheel.geometry import InnerCam, OuterCam
from analytic.freewheel.limits import Limits, pop_through
from analytic.freewheel.limits import limits as torque_limits
from analytic.freewheel.load_path import AlternatingAxial, AxialRamp, BothAlternating, LoadPath
from analytic.freewheel.state import State, at_angle, at_normal_force, loaded
from analytic.freewheel.tolerance import Ensemble, draw, sensitivities

__all__ = [
    "AlternatingAxial", "AxialRamp", "BothAlternating", "Clutch", "Course", "Ensemble",
    "InnerCam", "Limits", "LoadPath", "Material", "OuterCam", "State", "at_angle",
    "at_normal_force", "draw", "follow", "largest_axial_load", "loaded", "pop_through",
    "required_friction", "required_friction_of_ratio", "safety", "sensitivities",
    "torque_limits", "traffic_light",
]  # fmt: skip
