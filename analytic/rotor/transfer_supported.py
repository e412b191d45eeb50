"""Check that bearings and links support every shaft of a rotor, so that no free motion exists."""

import numpy as np
from numpy.typing import NDArray

from analytic.rotor.transfer_bending import pairs
from analytic.rotor.transfer_model import TransferMatrixRotor

FREE = 1e-12  # relative to the largest stiffness


def check_supported(rotor: TransferMatrixRotor, names: tuple[str, ...] = ()) -> None:
    """Raise ValueError if a shaft can move freely along x or y, or tilt.

    The message names the shaft and the free motion. `names` are the names of the shafts, by default
    numbers from 1.
    """
    values, vectors = np.linalg.eigh(rigid_stiffness(rotor))
    if values[-1] <= 0:
        raise ValueError("the rotor must be supported: no bearing supports it in x or y")
    if values[0] > FREE * values[-1]:
        return
    free = vectors[:, values <= FREE * values[-1]]
    share = (np.abs(free) ** 2).sum(axis=1).reshape(-1, 2, 2)  # shaft, shift or tilt, x or y
    shaft = int(share.sum(axis=(1, 2)).argmax())
    shift, tilt = share[shaft].sum(axis=1)
    x, y = share[shaft].sum(axis=0)
    along = "x and y" if min(x, y) > 0.5 * max(x, y) else "x" if x > y else "y"
    moved = "shifts and tilts" if min(shift, tilt) > 0.99 else "shifts" if shift > tilt else "tilts"
    name = names[shaft] if names else str(shaft + 1)
    raise ValueError(f"the rotor must be supported: shaft {name} {moved} freely in {along}")


def rigid_stiffness(rotor: TransferMatrixRotor) -> NDArray[np.float64]:
    """Stiffness matrix of rigid shaft motions: translation and tilt about the middle, in x and y.

    A tilt is measured by its displacement at the end of the shaft.
    """
    lengths = [sum(s.length for s in shaft.segments) for shaft in rotor.shafts]
    motions = np.zeros((rotor.stations, 4, 4 * len(rotor.shafts)))  # x, y, theta_y, -theta_x
    for node, (shaft, z) in enumerate(zip(rotor.shaft_of, rotor.places, strict=True)):
        half = lengths[shaft] / 2
        for across in range(2):
            shift, tilt = 4 * shaft + across, 4 * shaft + 2 + across
            motions[node, across, shift] = 1.0
            motions[node, across, tilt] = z / half - 1
            motions[node, 2 + across, tilt] = 1 / half
    K = np.zeros((motions.shape[2],) * 2)
    for spring in (*rotor.supports, *rotor.links):
        mean, other = spring.stiffness
        k = np.diag([mean + other.real, mean - other.real, spring.k_tilt, spring.k_tilt])
        k[0, 1] = k[1, 0] = other.imag
        for a, b, sign in pairs(spring):
            K += sign * motions[a].T @ k @ motions[b]
    return K
