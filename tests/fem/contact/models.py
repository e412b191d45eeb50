"""Bodies in contact for several tests: blocks, discs on a flat, rollers on each other."""

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.contact.disc import half_disc
from meshes.join import join

SOFT, HARD = Elastic(E=1.0, nu=0.3), Elastic(E=4.0, nu=0.2)
STEEL = Elastic(E=210e9, nu=0.3)


def tower(friction, *, on_floor=False, **problem):
    """A narrow block on a wide one, 0.5 high each; `on_floor` on a rigid floor as well."""
    mesh = join({"up": block(x=(0.2, 0.7), y=(0.5, 1.0), nx=6, ny=5),
                 "low": block(x=(0, 1), y=(0, 0.5), nx=11, ny=5)})  # fmt: skip
    contacts = [Pair(slave="up.bottom", master="low.top", friction=friction)]
    given = {"materials": {"up": SOFT, "low": HARD}, "assumption": "plane strain",
             "contacts": contacts}  # fmt: skip
    if on_floor:
        contacts.append(Pair(slave="low.bottom", master="floor", friction=friction))
        given["obstacles"] = {"floor": Obstacle(Flat())}
    return ContactProblem(mesh, **given | problem)


def on_flat(disc, *, friction=0.0, **problem):
    """A `disc` that touches a rigid flat at the origin with its lowest point."""
    R = disc.p[1].max()
    given = {
        "materials": STEEL, "assumption": "plane strain", "obstacles": {"flat": Obstacle(Flat())},
        "contacts": [
            Pair(slave="surface", master="flat", slave_shape=Circle((0, R), R), friction=friction)
        ],
    }  # fmt: skip
    return ContactProblem(disc, **given | problem)


def rollers(friction, *, R=10e-3, fine=None, **problem):
    """Two half discs that touch at the origin, the lower one held."""
    fine = {"R": R, "zone": 0.012 * R, "refine": 2} | (fine or {})
    mesh = join({"upper": half_disc(**fine), "lower": half_disc(**fine, below=True)})
    given = {
        "materials": STEEL, "assumption": "plane strain",
        "supports": {"lower.middle": "xy", "upper.middle": "xy"},
        "contacts": [
            Pair(slave="upper.surface", master="lower.surface", friction=friction,
                 slave_shape=Circle((0, R), R), master_shape=Circle((0, -R), R))
        ],
    }  # fmt: skip
    return ContactProblem(mesh, **given | problem)
