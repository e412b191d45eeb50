"""A ring for sweeps, and how many of its points are kept."""

import sqlite3
from contextlib import closing

RING = """
case = "polyhedral-ring"
[inputs]
d_e = "80 mm"
delta_1 = "4 mm"
j_D = "0.06 mm"
E = "210 GPa"
nu = 0.3
z = 6
rho = "2 mm"
e = "2 mm"
R_b = "200 N/mm"
tan_phi = 0.05
"""


def points(folder):
    """Points that the cache in `folder` holds, 0 where there is none."""
    path = folder / "cache" / "store.sqlite"
    if not path.exists():
        return 0
    with closing(sqlite3.connect(path, timeout=10)) as database:
        try:
            return database.execute(
                "SELECT COUNT(*) FROM entries WHERE kind = 'sweep reference'"
            ).fetchone()[0]
        except sqlite3.OperationalError:  # no table yet
            return 0
