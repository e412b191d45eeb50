from analytic.spring import energy, frame
from analytic.spring.column import critical_force, critical_shortening
from analytic.spring.elastica import Elastica
from analytic.spring.lines import Lines
from analytic.spring.moments import moment_diagram
from analytic.spring.stages import Stages
from analytic.spring.stages import stages as two_stages
from analytic.spring.wide_leaf import width_factor

__all__ = [
    "Elastica", "Lines", "Stages", "critical_force", "critical_shortening", "energy", "frame",
    "moment_diagram", "two_stages", "width_factor",
]  # fmt: skip
