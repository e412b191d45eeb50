"""Beams beside bodies and elements beside beams, within acceptance figures."""

from dataclasses import replace

import numpy as np

from verify.cases.rotor.shaft.fem import MODES
from verify.core.case import Context
from verify.judging.tolerance_checks import Pair, farthest

FINE = 1e-5  # of a slender shaft's frequency, 32 elements


def within_ceiling(context: Context) -> Pair:
    """Timoshenko's beam and the elastic body, of modes 1 to 3 where they differ most."""
    runs = [context.series(f"solid {j} at rest")[1] for j in MODES]
    beams = np.array([context.analytic[f"timoshenko {j} at rest"] for j in MODES])
    bodies = np.array([v[-1] for v in runs])
    found = farthest(beams, bodies, max(abs(v[-1] / v[-2] - 1) for v in runs))
    return replace(found, words=", ".join(f"{x:+.4%}" for x in beams / bodies - 1))


def slender(context: Context) -> Pair:
    """The beam and 32 elements, the finest, on a shaft of d/L = 0.03."""
    v, beam = context.series("beam slender")[1][-1], context.analytic["slender"]
    return Pair(beam, v, 1e-9 * abs(v), f"{v / beam - 1:.1e}")
