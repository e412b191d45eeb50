"""Invalid rings and springs are refused in one line that names the error."""

import math
from contextlib import suppress

import numpy as np
import pytest

from analytic.ring import lame, rotating, smeared
from analytic.ring.fourier_ring import FourierRing
from analytic.ring.loaded_race import LoadedRace
from analytic.spring import column, frame
from analytic.spring.elastica import Elastica
from analytic.spring.stages import stages
from analytic.spring.wide_leaf import width_factor

nan = math.nan
LAME = {"r": 1.5, "r_i": 1.0, "r_o": 2.0, "p_i": 1.0}
SOLID = {"E": 1.0, "nu": 0.3, "ends": "plane stress"}
TURNING = {"r_i": 19.44e-3, "r_o": 26.23e-3, "rho": 7850.0, "omega": 628.0, "nu": 0.3}
WAVES = {"r_i": 1.0, "r_o": 2.0, "loaded": "bore", "n": 2, "p": np.ones(3), "E": 1.0, "nu": 0.3,
         "assumption": "plane strain"}  # fmt: skip
RACE = {"P": 1.0, "n": 12, "r_i": 1.0, "r_o": 2.0, "E": 1.0, "nu": 0.3, "loaded": "bore"}
SHAPE = {"L1": 11.6, "radius": 0.5, "alpha": math.radians(80)}
STRIP = {"b": 0.1, "h": 56.0, "E": 206e3}
SPRING = {"n": 10, **SHAPE, **STRIP}
PIECES = {"n": 10, **SHAPE, **STRIP, "nu": 0.3}
ENERGY = {"n": 10, "L1": 11.6, "r": 0.45, "alpha": math.radians(80), **STRIP}


def patches(**change):
    given = {**WAVES, "P": 1.0, "a": 0.1} | change
    del given["p"]
    return LoadedRace(**given)


REFUSED = [
    (lambda: lame.stresses(**LAME | {"r_i": 2.0}), "0 < r_i < r_o"),
    (lambda: lame.stresses(**LAME | {"r": 2.5}), r"wall \[1.0, 2.0\] m, got 2.5 m"),
    (lambda: lame.radial_displacement(**LAME, **SOLID | {"nu": 0.5}), "Poisson's ratio"),
    (lambda: lame.radial_displacement(**LAME, **SOLID | {"ends": "open"}), "ends"),
    (lambda: rotating.stresses(0.02, assumption="plane stress", **TURNING | {"omega": nan}),
     "angular speed must be positive"),
    (lambda: rotating.stresses(0.03, assumption="plane stress", **TURNING), "r must lie in the wa"),
    (lambda: FourierRing(**WAVES | {"n": 1}), "loads are in equilibrium, got n=1"),
    (lambda: FourierRing(**WAVES | {"loaded": "side"}), "'bore' or 'rim'"),
    (lambda: patches(n=12, a=0.3), "12 patches of half-width"),
    (lambda: smeared.race_deflection(**RACE | {"P": 0.0}), "load per length"),
    (lambda: column.unit(**SHAPE | {"L1": 0.0}, **STRIP, nu=0.3), "must be positive"),
    (lambda: column.unit(**SHAPE | {"alpha": 2.0}, **STRIP, nu=0.3), r"alpha .* in \(0, 90\] deg"),
    (lambda: column.free_length(n=2, **SHAPE), "at least 3 segments"),
    (lambda: Elastica([(1.0, 0.0)], EI=0.0), "EI, EA and GA must be positive"),
    (lambda: frame.stiffness(**PIECES | {"n": 2}), "at least 3 segments"),
    (lambda: frame.stiffness(**PIECES | {"b": 1.0}, theory="thick"), "less than twice its radius"),
    (lambda: frame.stiffness(**PIECES, head="free", hold="hinged"), "it can rotate freely"),
    (lambda: stages(**SPRING | {"n": 3}), "must have n >= 4 segments, got n=3"),
    (lambda: stages(**SPRING | {"alpha": 2.0}), r"alpha must lie in \(0, 90\] deg, got 114.59"),
    (lambda: stages(**SPRING, nu=0.7), r"Poisson's ratio must lie in \(-1, 0.5\], got nu=0.7"),
    (lambda: stages(**SPRING | {"b": 1.2}), "twice the radius, got b=1.2 m, radius=0.5 m"),
    (lambda: stages(**SPRING | {"radius": -0.5}), "radius must be positive .*, got -0.5 m"),
    (lambda: width_factor(1.0, 1.0, nu=0.6), r"Poisson's ratio must lie in \[0, 0.5\], got nu=0.6"),
    (lambda: width_factor(1.0, 1.0, terms=0), "terms must be at least 1, got 0"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "message"), REFUSED, ids=[message for _, message in REFUSED])
def test_rings_and_springs_that_make_no_sense_are_refused_in_one_line(call, message):
    with pytest.raises(ValueError, match=message) as refused:
        call()
    assert "\n" not in str(refused.value)


def test_a_path_that_leaps_has_no_numbers():
    EI, EA = 206e3 * 56 * 0.1**3 / 12, 206e3 * 56 * 0.1
    line = Elastica(frame.pieces(n=10, **SHAPE), EI=EI, EA=EA, GA=5 / 6 * EA / 2.6)
    with pytest.raises(ArithmeticError, match="use smaller steps"):
        line.path("guided", [1e6])  # too far for one correction, whatever its round-off
    for U in np.geomspace(120.0, 1e4, 200):  # the equations of some are singular by round-off
        with suppress(ArithmeticError):
            line.path("guided", [U])
