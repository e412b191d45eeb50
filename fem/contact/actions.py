"""Loads and prescribed displacements as sums of unit actions with stored responses.

If a step only changes magnitudes, it therefore needs no factorisation and no back-substitution.
"""

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from fem.contact.bodies import Bodies, Response
from fem.contact.pairs import MOTIONS
from fem.plane.discretisation import Array, Indices
from fem.plane.loads import (
    Pressure,
    Vector,
    body_load,
    force_load,
    point_load,
    surface_load,
)
from fem.plane.supports import Anchors, Conditions, Prescribed, Support, collect

Forces = Mapping[str, tuple[float, ...]]


@dataclass(frozen=True)
class Action:
    """`share` times a unit action, whose response is stored under `key`.

    A response that is not stored yet is calculated from `forces` and `displacements`.
    """

    share: float
    key: Hashable
    forces: Callable[[], Array] | None = None
    displacements: Callable[[], Array] | None = None

    def respond(self, bodies: Bodies) -> Response:
        """Response of `bodies` to the unit action."""
        none = np.zeros(bodies.count)
        f = none if self.forces is None else self.forces()
        u_0 = none if self.displacements is None else self.displacements()
        return bodies.respond(np.concatenate([f, none[f.size :]]), u_0)


class Supports:
    """Prescribed values of all supports, ordered by support and component."""

    def __init__(self, bodies: Bodies, supports: Mapping[str, Support], anchors: Anchors) -> None:
        self._bodies, self._supports = bodies, {k: components(s) for k, s in supports.items()}
        options: Any = {"turn": bodies.turn, "tied": bodies.tied}
        self.conditions: Conditions = collect(bodies.basis, supports, anchors, **options)
        for name in bodies.means:
            if name in self._supports or name in bodies.obstacles:
                raise ValueError(
                    f"the displacement and the mean displacement of {name!r} are both prescribed: "
                    "prescribe only one of them"
                )
        # the same supports with running numbers for values: the support of each condition
        keys = [(name, c) for name, held in self._supports.items() for c in held]
        self._number = {key: float(i + 1) for i, key in enumerate(keys)}
        numbered: dict[str, Support] = {
            name: {c: self._number[name, c] for c in held} for name, held in self._supports.items()
        }
        self._of = collect(bodies.basis, numbered, anchors, **options).value
        rest = np.arange(len(supports), len(self.conditions.owners))
        self._of[np.isin(self.conditions.owner, rest)] = 0.0

    def values(self, displacements: Mapping[str, Support]) -> Array:
        """Prescribed values (m,); the values in `displacements` replace those of the same supports.

        Order: conditions of supports, motions of obstacles, mean motions.
        """
        bodies = self._bodies
        means = [value for mean in bodies.means.values() for value in mean.held.values()]
        b = np.concatenate([self.conditions.value, np.zeros(3 * len(bodies.obstacles)), means])
        for name, given in displacements.items():
            new = components(given)
            held = list(self._supports.get(name, {}))
            if name in bodies.obstacles:
                held = [m for m in MOTIONS if m not in bodies.obstacles[name].free]
            elif name in bodies.means:
                held = list(bodies.means[name].held)
            if not held or set(new) - set(held):
                raise ValueError(
                    f"displacements of {name!r}: only components that the problem prescribes can "
                    f"have new values; prescribed components: {', '.join(held) or 'none'}, "
                    f"got {', '.join(new)}"
                )
            for c, value in new.items():
                own = self._conditions_of(name, c)
                if not callable(value):
                    b[own] = value
                elif name in bodies.obstacles or name in bodies.means:
                    raise ValueError(f"the motion {c} of {name!r} must be a number, got a function")
                else:
                    b[own] = value(bodies.basis.doflocs[:, self.conditions.dofs[0, own]])
        if not np.all(np.isfinite(b)):
            raise ValueError("prescribed displacements must be finite")
        return b

    def actions(self, displacements: Mapping[str, Support]) -> list[Action]:
        """Prescribed displacements as unit actions, one for each component of a support."""
        b = self.values(displacements)
        if not np.any(b):
            return []
        L = self._bodies.unknowns.L
        self._bodies.unknowns.displaced(b)  # contradictions show only in the sum
        of = np.concatenate([self._of, -1.0 - np.arange(b.size - self._of.size)])
        found = []
        for block in np.unique(of[b != 0]):
            own = of == block
            even = bool(block) and bool(np.all(b[own] == b[own][0]))
            share = float(b[own][0]) if even else 1.0
            part = np.where(own, 1.0 if even else b, 0.0)
            key = ("displacement", float(block)) if even else None
            found.append(Action(share, key, displacements=partial(L.__matmul__, part)))
        return found

    def _conditions_of(self, name: str, component: str) -> Indices:
        first = self.conditions.value.size
        if name in self._bodies.obstacles:
            first += 3 * list(self._bodies.obstacles).index(name)
            return np.array([first + MOTIONS.index(component)])
        if name in self._bodies.means:
            keys = [(n, c) for n, mean in self._bodies.means.items() for c in mean.held]
            return np.array(
                [first + 3 * len(self._bodies.obstacles) + keys.index((name, component))]
            )
        return np.flatnonzero(self._of == self._number[name, component])


class Loads:
    """Conversion of loads, given by name, to unit actions."""

    def __init__(self, bodies: Bodies) -> None:
        self._bodies = bodies
        self._scale, self._turn = bodies.thickness, bodies.turn

    def actions(
        self,
        pressures: Mapping[str, Pressure],
        tractions: Mapping[str, Vector],
        forces: Forces,
        body_forces: Vector | Mapping[str, Vector] | None,
        point_forces: Mapping[tuple[float, float], tuple[float, float]],
    ) -> list[Action]:
        """Actions that represent the loads.

        Raises ValueError for unknown names and for values that are not finite.
        """
        found: list[Action] = []
        for name, p in pressures.items():
            found += self._one(("pressure", name), p, partial(self._pressure, name))
        for name, t in tractions.items():
            found += self._components(("traction", name), t, partial(self._traction, name))
        for name, force in forces.items():
            if name in self._bodies.obstacles:
                make = partial(self._on_obstacle, name)
            else:
                make = partial(self._force, name)
            found += self._components(("force", name), force, make)
        if body_forces is not None:
            found.append(Action(1.0, None, partial(self._body_force, body_forces)))
        for point, force in point_forces.items():
            found += self._components(("point force", point), force, partial(self._at, point))
        return found

    def _one(
        self, key: tuple[str, str], value: Pressure, make: Callable[..., Array]
    ) -> list[Action]:
        if callable(value):
            return [Action(1.0, None, partial(make, value))]
        if not np.isfinite(value):
            raise ValueError(f"the {key[0]} on {key[1]!r} must be finite, got {value}")
        return [Action(float(value), key, partial(make, 1.0))]

    def _components(
        self, key: tuple[str, Hashable], value: Any, make: Callable[..., Array]
    ) -> list[Action]:
        if callable(value):
            return [Action(1.0, None, partial(make, value))]
        obstacle = self._bodies.obstacles.get(key[1]) if isinstance(key[1], str) else None
        most = 2 if obstacle is None else 3
        if not isinstance(value, tuple | list | np.ndarray):
            raise ValueError(
                f"the {key[0]} on {key[1]!r} must have components x and y, got {value!r}"
            )
        if not (2 <= len(value) <= most and np.all(np.isfinite(value))):
            raise ValueError(
                f"the {key[0]} on {key[1]!r} must have finite components x and y, got {value}"
            )
        for motion, v in zip(MOTIONS, value, strict=False):
            if obstacle is not None and v != 0 and motion not in obstacle.free:
                raise ValueError(
                    f"the force on obstacle {key[1]!r} has the component {v:g} along {motion}, "
                    f"but only free motions can be loaded: {obstacle.free or 'none'}"
                )
        units = np.eye(len(value))
        return [
            Action(float(v), (*key, i), partial(make, tuple(units[i].tolist())))
            for i, v in enumerate(value)
            if v != 0 or (i == 1 and not any(value))  # a name is checked even without a load
        ]

    def _pressure(self, name: str, p: Pressure) -> Array:
        return self._scale * surface_load(self._bodies.basis, {name: p}, {}, turn=self._turn)

    def _traction(self, name: str, t: Vector) -> Array:
        return self._scale * surface_load(self._bodies.basis, {}, {name: t}, turn=self._turn)

    def _force(self, name: str, force: tuple[float, float]) -> Array:
        return force_load(self._bodies.basis, {name: force}, turn=self._turn)

    def _body_force(self, forces: Vector | Mapping[str, Vector]) -> Array:
        return self._scale * body_load(self._bodies.basis, forces, turn=self._turn)

    def _at(self, point: tuple[float, float], force: tuple[float, float]) -> Array:
        return point_load(self._bodies.basis, {point: force}, turn=self._turn)

    def _on_obstacle(self, name: str, force: tuple[float, ...]) -> Array:
        """Forces (all,) from the force (x, y) and the moment about the centre of an obstacle."""
        f = np.zeros(self._bodies.count)
        first = self._bodies.basis.N + 3 * list(self._bodies.obstacles).index(name)
        f[first : first + len(force)] = force
        return f


def components(support: Support) -> dict[str, Prescribed]:
    """Prescribed value of each component of a support."""
    if not isinstance(support, str | Mapping):
        raise ValueError(f'a support must be like "xy" or {{"x": 1e-3}}, got {support!r}')
    return dict.fromkeys(support, 0.0) if isinstance(support, str) else dict(support)
