"""Nominal crowns and the corners of their grinding tolerance."""

import numpy as np

from verify.core.figures import Array
from verify.studies.design_sprag.inputs import Task


def corners(task: Task, crowns: Array) -> Array:
    """Nominal `crowns` (n, 3), followed by the c - 1 corners of their tolerances, (n, c, 3).

    The drop tolerance scales the whole profile: K_1 and z_m are multiplied by 1 ± t_z/z_m. K_2 is
    limited to 1, because a crown cannot begin beyond mid-length.
    """
    z_m = crowns[:, 2]
    found = [crowns]
    grown = (-1, 1) if task.wishes.t_z else (0,)
    moved = (-1, 1) if task.wishes.t_y else (0,)
    for more in grown:
        for longer in moved:
            if not more and not longer:
                continue
            factor = 1 + more * task.wishes.t_z / z_m
            K_2 = np.minimum(crowns[:, 1] + longer * task.t_K2, 1.0)
            found.append(np.column_stack([crowns[:, 0] * factor, K_2, z_m * factor]))
    return np.stack(found, axis=1)


def reach(task: Task) -> tuple[Array, Array]:
    """Lowest and highest (K_1, K_2, z_m) of the task: ends of its ranges, including tolerances."""
    share, moved = task.wishes.t_z / task.low[2], task.t_K2
    low = np.array(task.low) * [1 - share, 1, 1] - [0, moved, task.wishes.t_z]
    high = np.array(task.high) * [1 + share, 1, 1] + [0, moved, task.wishes.t_z]
    high[1] = min(high[1], 1.0)
    return low, high
