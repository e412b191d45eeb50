"""Lines and states for the tests of contact."""

import numpy as np
from scipy.spatial.transform import Rotation


def line(start, end, count, nodes=3, bulge=0.0):
    """Points and elements of a line of `count` elements, bowed to the left by `bulge`."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    s = np.linspace(0, 1, (nodes - 1) * count + 1)
    way = end - start
    left = np.array([-way[1], way[0]]) / np.hypot(*way)
    points = start + s[:, None] * way + bulge * np.sin(np.pi * s)[:, None] * left
    return points, chain(len(s), nodes)


def chain(points, nodes=3):
    first = np.arange(0, points - 1, nodes - 1)
    if nodes == 2:
        return np.column_stack([first, first + 1])
    return np.column_stack([first, first + 2, first + 1])


def ring(centre, radius, count):
    """A closed circle that begins at its lowest point and runs counter-clockwise."""
    angle = 2 * np.pi * np.arange(2 * count) / (2 * count) - np.pi / 2
    points = np.asarray(centre) + radius * np.column_stack([np.cos(angle), np.sin(angle)])
    first = np.arange(0, 2 * count, 2)
    return points, np.column_stack([first, (first + 2) % (2 * count), first + 1])


def together(*lines):
    """Points and elements of several lines, and the first node of each."""
    points, elements, firsts = [], [], []
    for own, cells in lines:
        firsts.append(sum(map(len, points)))
        points.append(own)
        elements.append(cells + firsts[-1])
    return np.concatenate(points), np.concatenate(elements), firsts


def at_rest(points):
    return np.column_stack([points, np.zeros(len(points))])


def rotated(x, angle):
    """Positions and rotations (n, 3) after a rigid rotation around the origin."""
    turn = Rotation.from_euler("z", angle).as_matrix()[:2, :2]
    return np.column_stack([x[:, :2] @ turn.T, x[:, 2] + angle])


def differences(term, x, step=1e-6):
    """Central differences of a term's energy (3n,) and force (3n, 3n)."""
    energy, force = np.zeros(x.size), np.zeros((x.size, x.size))
    for i in range(x.size):
        move = np.zeros(x.size)
        move[i] = step
        after, before = (term.evaluate(x + way * move.reshape(-1, 3)) for way in (1, -1))
        energy[i] = (after[0] - before[0]) / (2 * step)
        force[:, i] = (after[1] - before[1]) / (2 * step)
    return energy, force


def couples(x, force):
    """Resultant (x, y, couple around the origin) of nodal forces (3n,)."""
    f = force.reshape(-1, 3)
    about = x[:, 0] * f[:, 1] - x[:, 1] * f[:, 0] + f[:, 2]
    return np.array([f[:, 0].sum(), f[:, 1].sum(), about.sum()])
