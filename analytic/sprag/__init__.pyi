from analytic.sprag.closure import Wedged, at_rotation, at_torque, closed
from analytic.sprag.clutch import Clutch
from analytic.sprag.compliance import Compliance
from analytic.sprag.compression import sprag_compression
from analytic.sprag.crowned import Crowned
from analytic.sprag.elastic import Elastic, Race
from analytic.sprag.events import engage_by_events
from analytic.sprag.geometry import LogSprag
from analytic.sprag.history import Engagement
from analytic.sprag.limits import Limits
from analytic.sprag.limits import limits as torque_limits
from analytic.sprag.motion import Motion, Torque
from analytic.sprag.parts import Parts
from analytic.sprag.race_spring import RaceSpring
from analytic.sprag.sudden import engage_suddenly
from analytic.sprag.table import tabulated
from analytic.sprag.tolerance import Sensitivities, sensitivities
from analytic.sprag.transient import engage

__all__ = [
    "Clutch", "Compliance", "Crowned", "Elastic", "Engagement", "Limits", "LogSprag", "Motion",
    "Parts", "Race", "RaceSpring", "Sensitivities", "Torque", "Wedged", "at_rotation",
    "at_torque", "closed", "engage", "engage_by_events", "engage_suddenly", "sensitivities",
    "sprag_compression", "tabulated", "torque_limits",
]  # fmt: skip
