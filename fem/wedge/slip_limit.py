"""Friction limit of a roller, as a function of friction coefficient, wedge angle and axial load."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from fem.contact.errors import NotFoundError
from fem.wedge.drive import Drive, Driven
from fem.wedge.flat import Sector, State
from fem.wedge.flat_place import Pitch, Place
from fem.wedge.flat_start import COARSE, Start
from fem.wedge.pulled import Borne, Pulled, held_along, slipping

Array = NDArray[np.float64]

BELOW, ABOVE = 1e-3, 1.4e-3  # of tan(psi/2): first bracket of the onset under torque
STICKING_TOLERANCE = 1e-9  # relative to N: less on sticking nodes is round-off
ONSET_WIDTH = 1e-6  # of tan(psi/2): last bracket
AXIAL_ABOVE = 1e-3  # of mu_req: the first friction with an axial load
SHARES = (1.01, 1.06, 1.15, 1.35, 1.8, 3.0)  # mu/tan(alpha) of the slip shares
ANGLES = (0.3, 0.5, 0.7, 0.85, 0.97, 1.03, 1.2, 1.5)  # tan(alpha)/mu of the sweep
HELD = 0.5  # relative to N: with less, the contacts count as released
DRIVEN = (1.5, 3.0)  # displacement of the ring along z for full slip, over the parts' deflection


class Limit:
    """Friction limit of the clutch at its position under torque, for various friction coefficients.

    Slip follows Coulomb's law at the normals of the mesh: `tan` is the tangent of the mesh angle.
    """

    def __init__(self, one: Pulled, start: Start, drags: tuple[float, float]) -> None:
        self.one, self.start, self.drags = one, start, drags
        self.place = Place.overlapping(one.q, *start.d)
        self.tan = math.tan(self.place.psi / 2)

    def slipping(self, mu: float) -> Array:
        """Share (2,) of N at nodes that slip, for each contact; 1 if contact is lost."""
        return slipping(self._under_torque(mu))

    def sticks(self, mu: float) -> bool:
        """True if loaded nodes of at least one contact stick, so that friction holds the roller."""
        return bool(self.slipping(mu).min() < 1 - STICKING_TOLERANCE)

    def _under_torque(self, mu: float) -> State:
        return Sector(self.place, self.start.widths, COARSE, mu=mu).at(self.drags)

    def shares(self) -> Array:
        """Rows (3, m): ratios mu/tan(alpha), and the results of `slipping` for both contacts."""
        found = [(k, *self.slipping(k * self.tan)) for k in SHARES]
        return np.array(found).T

    def of_torque(self) -> Array:
        """Ratio mu/tan(psi/2) at which both contacts slip completely, and uncertainty, (2,).

        The uncertainty is half the width of the interval in which the ratio lies.
        """
        steps = math.ceil(math.log2((BELOW + ABOVE) / ONSET_WIDTH))
        return self._bisected(lambda k: self.sticks(k * self.tan), 1 - BELOW, 1 + ABOVE, steps)

    def of_load(self) -> Array:
        """Smallest mu that holds the axial load, divided by `full`, and its uncertainty, (2,).

        The clutch is under its torque.
        """
        if self.asked == 0:
            return self.of_torque()
        first = 1 + AXIAL_ABOVE
        second, _ = self._corrected(first)
        if second < first and not self.sticks(second * self.full):
            # the first carries more than the load; at the second, the torque alone causes slip
            return np.array([(first + second) / 2, (first - second) / 2])
        found, doubt = self._corrected(second)
        return np.array([found, doubt + abs(found - second)])

    def _corrected(self, k: float) -> tuple[float, float]:
        """Smallest mu that holds the axial load, divided by `full`, and its uncertainty.

        It is calculated from the state of slip with the friction coefficient k x `full`. If all
        nodes slip, mu is F_t/N times sqrt(1 + (F_ax R/T)²), and F_t/N hardly changes.
        """
        lever, doubt = self._lever(k * self.full)
        found = k * math.hypot(1.0, self.asked) / math.hypot(1.0, lever)
        return found, found * doubt * lever / (1 + lever**2)

    def bears(self, mu: float) -> bool:
        """True if friction `mu` holds the clutch under its torque and its axial load.

        Raises NotFoundError if the axial load is within the uncertainty of the limit.
        """
        if not self.sticks(mu):  # under the torque alone
            return False
        lever, doubt = self._lever(mu)
        if abs(lever - self.asked) <= doubt:
            raise NotFoundError(
                f"F_ax R/T = {self.asked:.4g} is within the uncertainty {doubt:.1e} of the limit "
                f"{lever:.4g}: whether the clutch holds cannot be decided"
            )
        return lever > self.asked

    @property
    def asked(self) -> float:
        """Ratio F_ax R/T of axial load to torque."""
        return self.one.lever

    @property
    def full(self) -> float:
        """Friction coefficient by Eq. 8 for the wedge angle of the mesh: `tan` sqrt(1 + asked²)."""
        return math.hypot(1.0, self.asked) * self.tan

    def _lever(self, mu: float) -> tuple[float, float]:
        """Ratio F_ax R/T at slip with friction `mu` on coarse meshes, and its uncertainty."""
        start = replace(self.start, drags=self.drags)
        drive = Drive.at(replace(self.one, mu=mu), start, COARSE)
        return drive.lever(Driven(drive.rest, 0.0))

    @staticmethod
    def _bisected(holds: Callable[[float], bool], low: float, high: float, steps: int) -> Array:
        if holds(low) or not holds(high):
            return np.array([math.nan, 0.0])
        for _ in range(steps):
            middle = (low + high) / 2
            low, high = (low, middle) if holds(middle) else (middle, high)
        return np.array([(low + high) / 2, (high - low) / 2])


def over_angles(
    one: Pulled, start: Start, stuck: State, *, N: float, unit: float,
    built: Callable[[float], Pitch],
) -> Array:  # fmt: skip
    """Friction limits of clutches that differ only in the distance X of the flats.

    The overlaps of the contacts are equal in all clutches. The result has one row (m, 7) per
    clutch. `built` generates the pitch with flats at X [m]; it raises ValueError if such a pitch is
    impossible, and the row is omitted. Rows contain tan(alpha)/mu, the normal force divided by `N`
    [N/m], F_t/(mu N) (0 if the roller is released), and F_t/(mu N) and F_z/(mu N) of cam and ring
    after the ring was driven along z until all contacts slip. `unit` [m] is the displacement of the
    ring along z at the friction limit of `stuck`, calculated without slip. Angles and forces refer
    to the normals of the mesh, because slip depends on them.
    """
    q, mu, (d_i, d_o) = one.q, one.mu, start.d
    own = math.tan(Place.overlapping(q, *start.d).psi / 2) / mu
    most = unit / math.sqrt(1 - own**2)  # under all of mu N
    along, found = held_along(q, driven=True), []
    for k in ANGLES:
        psi = 2 * math.atan(k * mu)
        X = (q.race - q.r + d_o) * math.cos(psi) - q.r + d_i
        try:
            place = Place.overlapping(built(X), d_i, d_o)
            there = Sector(place, start.widths, COARSE, mu=mu, along=along)
        except ValueError:  # no such clutch, or none that can be meshed
            continue
        found.append([k, *_one_angle(there, stuck.drags, N, most)])
    return np.array(found)


def _one_angle(there: Sector, drags: tuple[float, float], N: float, most: float) -> list[float]:
    state = there.at(drags)
    borne = Borne.on_mesh(state)
    mean = float(borne.N.mean())
    if mean < HELD * N:
        return [mean / N] + [0.0] * 5
    mu = there.problem.surfaces.pairs[0].friction
    alone = borne.tangent / mu
    for u in DRIVEN:
        rim = {there.place.q.names.race_held: u * most}
        state = there.at(drags, after=state.solution, axial_displacements=rim)
    b = Borne.on_mesh(state)
    t, z = b.F_t / (mu * b.N), np.abs(b.F_z) / (mu * b.N)
    return [mean / N, alone, t[0], z[0], t[1], z[1]]
