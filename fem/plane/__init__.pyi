from fem.plane.material import Elastic
from fem.plane.means import Mean
from fem.plane.polygon import PolygonRing, solve_polygon_ring
from fem.plane.samples import Samples
from fem.plane.sectors import all_sectors, largest_hoop_stress, radial
from fem.plane.solution import PlaneSolution
from fem.plane.solve import solve_plane
from fem.plane.ties import Tie

__all__ = [
    "Elastic", "Mean", "PlaneSolution", "PolygonRing", "Samples", "Tie", "all_sectors",
    "largest_hoop_stress", "radial", "solve_plane", "solve_polygon_ring",
]  # fmt: skip
