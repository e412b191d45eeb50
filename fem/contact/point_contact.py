"""Point contacts of bodies of revolution: approach of the bodies, and stresses near the axis."""

import numpy as np

from fem.contact.errors import NotFoundError
from fem.contact.problem import ContactProblem
from fem.contact.solution import ContactSolution
from fem.plane.discretisation import Array

HIT, STEPS = 1e-12, 30  # relative error of the load, and largest number of steps
ABOUT, WIDE = (0.25, 0.75), 0.3  # z/a about the largest shear stress, and r/a


def push(state: ContactSolution) -> float:
    """Force [N] on the upper body along y."""
    return -state.touches[0].force[1]


def at_load(
    problem: ContactProblem, P: float, approach: float, state: ContactSolution
) -> tuple[float, ContactSolution]:
    """Approach of the bodies [m] under the force `P`, and the contact state under this force.

    A secant method begins with the contact state `state` at `approach`. The boundary "upper.middle"
    is displaced along -y. Raises NotFoundError if the force does not converge to `P`.
    """
    force, step = push(state), 0.6 * approach * (P / push(state) - 1)
    for _ in range(STEPS):
        if abs(force / P - 1) <= HIT:
            return approach, state
        before, approach = force, approach + step
        state = problem.solve(displacements={"upper.middle": {"y": -approach}}, after=state)
        force = push(state)
        if force != before:
            step *= (P - force) / (force - before)
    raise NotFoundError(f"the load {P:g} N was not reached: relative error {force / P - 1:.1e}")


def middle_pressure(r: Array, p: Array, a: float) -> float:
    """Pressure at the centre of contact, from a fit of sqrt(1 - r²/a²) (b + c r²/a²) for r < a/2.

    The pressure of the node on the axis is inaccurate, because its area is nearly zero.
    """
    s = r[r < a / 2] / a
    ellipse = np.sqrt(1 - s**2)
    columns = np.column_stack([ellipse, ellipse * s**2])
    return float(np.linalg.lstsq(columns, p[r < a / 2], rcond=None)[0][0])


def axis_stresses(state: ContactSolution, y: Array) -> tuple[Array, Array]:
    """Radial and axial stress (m,) at the positions y (m,) on the axis."""
    stress = state.plane.at(np.array([np.zeros_like(y), y])).stress
    return stress[0], stress[1]


def largest_axis_shear(x: Array, stress: Array, a: float) -> tuple[float, float]:
    """Largest shear stress on the axis, and its depth divided by `a`.

    A polynomial, even in r, is fitted to (sigma_r - sigma_z)/2 at the points `x` (2, m) near the
    axis, because stresses are discontinuous between cells.
    """
    r, z = x[0] / a, np.abs(x[1]) / a
    near = (r < WIDE) & (z > ABOUT[0]) & (z < ABOUT[1])
    r, z, shear = r[near], z[near], (stress[0] - stress[1])[near] / 2
    columns = [z**i * r ** (2 * j) for j in range(3) for i in range(6 - j)]
    fit = np.linalg.lstsq(np.array(columns).T, shear, rcond=None)[0]
    fine = np.linspace(*ABOUT, 4001)
    on_axis = np.polynomial.polynomial.polyval(fine, fit[:6])
    best = int(np.argmax(on_axis))
    return float(on_axis[best]), float(fine[best])
