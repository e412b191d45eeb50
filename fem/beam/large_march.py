"""Steps along an equilibrium path: prediction, Newton's method, step halving, work of forces."""

import math
from dataclasses import dataclass, replace

import numpy as np

from fem.beam.large_balance import Balance, ConvergenceError, Response, Tangent
from fem.beam.large_elements import Extended
from fem.beam.large_newton import Control, equilibrium
from fem.beam.large_state import BeamState
from fem.beam.section import Array

HALVINGS = 12
GAUSS = np.polynomial.legendre.leggauss(3)


@dataclass(frozen=True)
class Given:
    """Step control by a given change of the load factor."""

    change: float
    kink = math.inf

    def correct(self, moved: Array, step: Array, push: Array) -> float:  # noqa: ARG002
        return 0.0

    def speed(self, push: Array, moved: Array) -> float:  # noqa: ARG002
        return self.change


class March:
    """Steps from one equilibrium state to the next; a failed step leaves the state unchanged."""

    def __init__(self, balance: Balance, start: BeamState) -> None:
        self.balance = balance
        self._look(start)
        self.state = replace(start, negative=self.tangent.negative)

    def _look(self, here: BeamState) -> None:
        self.response: Response = self.balance.respond(here.exact, here.factor)
        self.tangent: Tangent = self.balance.factorise(here.exact, self.response.K)

    def step(self, change: float, control: Control, *, crossing: bool = True) -> BeamState:
        """State after a step; `change` is the predicted change of the load factor.

        Raises ConvergenceError, with unchanged state, if the step fails. It is also raised if a
        pivot changes its sign and `crossing` is False.
        """
        balance, before = self.balance, self.state
        try:
            predicted = change * self.tangent.push
            if not float(abs(predicted[2::3]).max()) < 2.0:
                raise ConvergenceError(
                    "the step predicted by the tangent stiffness rotates a section by more than "
                    "2 rad"
                )
            stress = self.response.predict(predicted)
            u, factor, found, residuals = equilibrium(
                balance, before, predicted, change, stress, control
            )
            tangent = balance.factorise(u, found.K)
            if tangent.negative != before.negative and not crossing:
                raise ConvergenceError("the step crosses a critical point or leaves the branch")
            if self._strayed(u, predicted) > (control.kink if balance.terms else 1.0):
                raise ConvergenceError("the step ends on another branch of the equilibrium path")
        except ConvergenceError:
            for term in balance.terms:
                term.reject()
            raise
        moved = (u - before.exact).astype(float).ravel()
        work = before.work + self._work(moved, control, found, tangent)
        for term in balance.terms:
            term.accept(balance.positions(u))
        self.state = BeamState(
            factor, u, balance.base.plus(factor, balance.pattern), balance.held, found.internal,
            found.strain_energy, found.term_energy,
            sum(term.dissipated for term in balance.terms), work, residuals, 1, tangent.negative,
        )  # fmt: skip
        self.response, self.tangent = found, tangent
        if balance.terms:  # with another history they may differ
            self._look(self.state)
        return self.state

    def reach(self, factor: float) -> BeamState:
        """State at a given load factor, reached in as few steps as Newton's method permits."""
        start, steps, good = self.state.factor, 0, 1
        whole = size = factor - start
        while True:
            rest = factor - self.state.factor
            size = rest if abs(size) >= abs(rest) * (1 - 1e-9) else size
            try:
                # a longer step past a critical point may end on another branch
                smallest = abs(size) < 2 * abs(whole) / 2**HALVINGS
                self.step(size, Given(size), crossing=smallest)
            except ConvergenceError as error:
                size, good = size / 2, 0
                if abs(size) < abs(whole) / 2**HALVINGS:
                    raise ArithmeticError(
                        f"no equilibrium was found beyond factor {self.state.factor:.6g} towards "
                        f"{factor:.6g}: {error}, with steps down to {2 * size:.1e}; "
                        "to pass a limit point, use along_arc()"
                    ) from error
                continue
            steps, good = steps + 1, good + 1
            if size == rest:
                self.state = replace(self.state, factor=factor, steps=steps)
                return self.state
            size *= 2 if good > 1 else 1

    def _strayed(self, u: Extended, predicted: Array) -> float:
        """Squared deviation of a step from its prediction, relative to the squared prediction."""
        off = (u - self.state.exact).astype(float).ravel() - predicted
        weights = self.balance.weights
        size = float(weights * predicted @ predicted)
        return float(weights * off @ off) / size if size else 0.0

    def _work(self, moved: Array, control: Control, found: Response, tangent: Tangent) -> float:
        """Work of all nodal forces over a step; forces and displacements are cubic functions."""
        push = self.tangent.push, tangent.push
        ahead, behind = (control.speed(p, moved) * p for p in push)
        x = (GAUSS[0] + 1) / 2
        value = np.array([2 * x**3 - 3 * x**2 + 1, x**3 - 2 * x**2 + x, -2 * x**3 + 3 * x**2,
                          x**3 - x**2])  # fmt: skip
        slope = np.array([6 * x**2 - 6 * x, 3 * x**2 - 4 * x + 1, -6 * x**2 + 6 * x,
                          3 * x**2 - 2 * x])  # fmt: skip
        force = value.T @ np.array([
            self.response.internal, self.tangent.K @ ahead, found.internal, tangent.K @ behind,
        ])  # fmt: skip
        speed = slope.T @ np.array([np.zeros_like(moved), ahead, moved, behind])
        return float(GAUSS[1] / 2 @ (force * speed).sum(axis=1))
