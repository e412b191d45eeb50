from analytic.sprag.closure import Wedged, at_rotation, at_torque, closed
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.compliance import Compliance
from analytic.sprag.compression import sprag_compression
from analytic.sprag.crowned import Crowned
from analytic.sprag.elastic import ElasticSpragClutch, Race
from analytic.sprag.events import engage_by_events
from analytic.sprag.geometry import LogSprag
from analytic.sprag.history import Engagement
from analytic.sprag.limits import SpragClutchLimits, sprag_torque_limits
from analytic.sprag.motion import Motion, Torque
from analytic.sprag.parts import SpragClutchParts
from analytic.sprag.race_spring import RaceSpring
from analytic.sprag.sudden import engage_suddenly
from analytic.sprag.table import tabulated
from analytic.sprag.tolerance import Sensitivities, wedge_angle_sensitivities
from analytic.sprag.transient import engage

Clutch = SpragClutch  # its name in version 0.1
Elastic = ElasticSpragClutch  # its name in version 0.1
Limits = SpragClutchLimits  # its name in version 0.1
Parts = SpragClutchParts  # its name in version 0.1
sensitivities = wedge_angle_sensitivities  # its name in version 0.1
torque_limits = sprag_torque_limits  # its name in version 0.1

__all__ = [
    "Compliance", "Crowned", "ElasticSpragClutch", "Engagement", "LogSprag", "Motion", "Race",
    "RaceSpring", "Sensitivities", "SpragClutch", "SpragClutchLimits", "SpragClutchParts", "Torque",
    "Wedged", "at_rotation", "at_torque", "closed", "engage", "engage_by_events", "engage_suddenly",
    "sprag_compression", "sprag_torque_limits", "tabulated", "wedge_angle_sensitivities",
]  # fmt: skip
