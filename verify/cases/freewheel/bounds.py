"""Error bounds of the formulas of star and cup, from the inputs and states of their cases."""

from analytic.bounds.freewheel.intervals import Interval
from analytic.bounds.freewheel.parts import FreewheelParts, Loaded
from analytic.bounds.freewheel.star import StarBounds
from analytic.freewheel.state import RollerClutchState
from verify.case import Expected
from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.star import Star

WIDEST = 8e-3  # interval with which a row of a user's star is sharp enough

BRACKET = (
    "compliance of the star, which lies between the smallest and the largest compliance of three "
    "bodies: a layer as thick as the star at the flats, a disc of the radius of the flats, and a "
    "disc of the radius of the corners; wind-up of the star; terms of the order (a/r)², which "
    "Hertz's theory omits"
)
TANGENTIAL = (
    f"{BRACKET}; additional rotation of the ring by the tangential forces, 0.5 tan²α to tan²α "
    "times the wind-up"
)


def parts(q: OneClutch) -> FreewheelParts:
    """Dimensions and material of a star or a cup."""
    return FreewheelParts(sense=q.sense, race=q.race, flat=q.flat, r=q.r, z=q.z, L=q.L,
                 r_b=q.r_b, R_a=q.R_a, E=q.E, nu=q.nu)  # fmt: skip


def sizes(state: RollerClutchState) -> Loaded:
    """Force, torque, angle, approaches and contact half-widths in `state`, for the error bounds."""
    s = state
    return Loaded(N=float(s.N), T=float(s.T), alpha=float(s.alpha), d_i=float(s.d_i),
                  d_o=float(s.d_o), a_i=float(s.a_i), a_o=float(s.a_o))  # fmt: skip


def of_star(q: OneClutch, state: RollerClutchState) -> StarBounds:
    """Error bounds of the formulas of a star in the given state."""
    return StarBounds(parts(q), sizes(state))


def known(q: Star, interval: Interval, source: str = BRACKET) -> Expected:
    """Expected error of a row: within `interval`, which was derived as `source` states.

    For user inputs, a row with an interval wider than `WIDEST` is not judged.
    """
    low, high = interval
    return Expected(low, high, source, sharp=q.is_default or high - low <= WIDEST)
