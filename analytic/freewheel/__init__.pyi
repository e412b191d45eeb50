from analytic.freewheel.clutch import ContactMaterial, RollerClutch
from analytic.freewheel.course import Course, follow
from analytic.freewheel.criterion import (
    largest_axial_load,
    required_friction,
    required_friction_of_ratio,
    safety,
    traffic_light,
)
from analytic.freewheel.geometry import InnerCam, OuterCam
from analytic.freewheel.limits import RollerClutchLimits, pop_through, roller_torque_limits
from analytic.freewheel.load_path import AlternatingAxial, AxialRamp, BothAlternating, LoadPath
from analytic.freewheel.state import RollerClutchState, at_angle, at_normal_force, loaded
from analytic.freewheel.tolerance import Ensemble, clamping_angle_sensitivities, draw

Clutch = RollerClutch  # its name in version 0.1
Limits = RollerClutchLimits  # its name in version 0.1
Material = ContactMaterial  # its name in version 0.1
State = RollerClutchState  # its name in version 0.1
sensitivities = clamping_angle_sensitivities  # its name in version 0.1
torque_limits = roller_torque_limits  # its name in version 0.1

__all__ = [
    "AlternatingAxial", "AxialRamp", "BothAlternating", "ContactMaterial", "Course", "Ensemble",
    "InnerCam", "LoadPath", "OuterCam", "RollerClutch", "RollerClutchLimits", "RollerClutchState",
    "at_angle", "at_normal_force", "clamping_angle_sensitivities", "draw", "follow",
    "largest_axial_load", "loaded", "pop_through", "required_friction",
    "required_friction_of_ratio", "roller_torque_limits", "safety", "traffic_light",
]  # fmt: skip
