"""The clutch of Huang 2018 with a round wedge angle in radians, for tests without fixtures."""

from analytic.sprag.geometry import LogSprag
from analytic.sprag.parts import SpragClutchParts

SPRAG = LogSprag.from_wedge_angle(nu_0=0.055, R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3)
PARTS = SpragClutchParts(
    sprag=SPRAG, n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3
)
