from fem.rotor.campbell import Campbell
from fem.rotor.campbell import campbell as campbell_diagram
from fem.rotor.critical import CriticalSpeeds, critical_speeds
from fem.rotor.damping import Modal, Rayleigh
from fem.rotor.model import Rotor
from fem.rotor.modes import Modes
from fem.rotor.modes import modes as solve_modes
from fem.rotor.parts import Disc, Element, Link, Material, Shaft, SpeedSupport, Support
from fem.rotor.parts import joint as shaft_joint
from fem.rotor.response import (
    Orbit,
    Response,
    forced_response,
    unbalance_response,
    unbalance_responses,
)
from fem.rotor.splitting import gyroscopic_splitting

__all__ = [
    "Campbell", "CriticalSpeeds", "Disc", "Element", "Link", "Material", "Modal", "Modes",
    "Orbit", "Rayleigh", "Response", "Rotor", "Shaft", "SpeedSupport", "Support",
    "campbell_diagram", "critical_speeds", "forced_response", "gyroscopic_splitting",
    "shaft_joint", "solve_modes", "unbalance_response", "unbalance_responses",
]  # fmt: skip
