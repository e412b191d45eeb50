"""Invalid contacts are refused in one line that names the error."""

import numpy as np
import pytest

from analytic.contact import (
    clamped_race,
    crown,
    disc,
    hertz_line,
    hertz_line_approach,
    hertz_line_stress,
    hertz_point,
    lamina,
    palmgren,
    partial_slip,
    press_fit,
    slice_compliance,
    slices,
    sphere_series,
    strip_error,
    strips,
    tangential_cycle,
)
from analytic.contact.best_crown import best_crown
from analytic.contact.edge import edge_exponent
from analytic.contact.half_space import HalfSpace, press_half_space
from analytic.contact.half_space_roller import press_roller

nan, inf = np.nan, np.inf
STEEL = {"E": 206e9, "nu": 0.3, "assumption": "plane strain"}
PAIR = {"E_1": 1.0, "nu_1": 0.3, "E_2": 1.0, "nu_2": 0.3, "assumption": "plane strain"}
LINE = {"P": 3.0, "R": 0.7, "E_star": 400.0}
LOAD = {"Q": 0.3, "P": 2.0, "mu": 0.4, "a": 0.5}
CYCLE = {"Q": 0.0, "Q_max": 0.6, "P": 2.0, "mu": 0.4, "a": 0.5, "branch": "unloading"}
ROLLER = {"length": 9e-3, "R": 2.952e-3, "E_star": 113.2e9}
DESIGN = {"load": 3400.0, "length": 9e-3, "E_star": 113.2e9}
PAPER = {"K_1": 2.1507, "K_2": 0.6763, "z_m": 12.1e-6, **DESIGN}
RACE = {"P": 1.0, "a": 0.01, "r_i": 1.0, "r_o": 1.5, **STEEL}
GRID = {"gap": [[0.0, 0.0]], "cell": (1.0, 1.0), "E_star": 1.0, "load": 1.0}
SHAFT = press_fit.Wall(r_i=0.4, r_o=1.0, E=3.0, nu=0.2)
SLEEVE = press_fit.Wall(r_i=1.0, r_o=1.3, E=1.0, nu=0.35)
BALL = sphere_series.Sphere(R=1.0, E=206e9, nu=0.3)
RIGID = sphere_series.Sphere(R=inf, E=inf, nu=0.0)


def fit(*walls, delta=1e-3, **loads):
    return press_fit.contact_pressures(walls, delta, **{"assumption": "plane stress"} | loads)


def overlap(bore, **loads):
    hub = press_fit.Wall(r_i=bore, r_o=1.3, E=1.0, nu=0.35)
    return press_fit.pressure_of_overlap(SHAFT, hub, assumption="plane stress", **loads)


def pressed(by, gap=(0.0, 1e-6), **change):
    return by.press(gap, **{"load": 100.0, **ROLLER} | change)


def strips_of(n):
    return strips.press_strips(np.zeros(n), load=100.0, **ROLLER)


REFUSED = [
    (lambda: hertz_line.relative_radius(R_1=1.0, R_2=-0.5), "R_2 must be positive or, for a bore"),
    (lambda: hertz_line.half_width(**LINE | {"P": 0.0}), "positive and finite, got 0.0 N/m$"),
    (lambda: hertz_line.contact_modulus(**PAIR | {"nu_1": 0.5}), "Poisson's ratio"),
    (lambda: hertz_line.contact_modulus(**PAIR | {"E_1": inf, "E_2": inf}), "must be elastic"),
    (lambda: hertz_line.contact_modulus(**PAIR | {"assumption": "free"}), "plane stress, plane st"),
    (lambda: hertz_line_approach.approach_to_depth(-1.0, P=2.0, a=0.3, **STEEL), "depth"),
    (lambda: hertz_line_approach.approach_to_centre(P=1.0, a=1.0, R=1.0, E_plane=1.0),
     r"less than the radius, got a=1\.0 m, R=1\.0 m"),
    (lambda: hertz_line_stress.stresses(0.0, -0.1, a=0.5, p_0=3.0), "depth must be finite and not"),
    (lambda: hertz_point.load(delta=-1.0, R=1.0, E_star=1.0), "approach"),
    (lambda: sphere_series.pressed_spheres(BALL, RIGID, P=0.0), "load must be .* N"),
    (lambda: sphere_series.pressed_spheres(RIGID, RIGID, P=1.0), "one body must be elastic"),
    (lambda: partial_slip.traction(0.0, **LOAD | {"Q": 0.8}), "limit mu P = 0.8 N/m, got 0.8 N/m"),
    (lambda: partial_slip.slip(0.6, **LOAD, E_star=7.0), r"in the contact, \|x\| <= a = 0.5 m"),
    (lambda: tangential_cycle.traction(0.0, **CYCLE | {"Q": 0.7}), "-Q_max and Q_max = 0.6 N/m, g"),
    (lambda: tangential_cycle.traction(0.0, **CYCLE | {"Q_max": 0.8}), "the contact slides"),
    (lambda: tangential_cycle.traction(0.0, **CYCLE | {"branch": "down"}), "branch must be one of"),
    (lambda: disc.disc_in_contact(a=0.95, R=1.0, E_plane=1.0), "at most 0.9 R, got a=0.95 m, R="),
    (lambda: disc.disc_under_load(P=10.0, R=1.0, E_plane=1.0), "at most a = 0.9 R"),
    (lambda: edge_exponent(1.5), r"angle of the edge must lie in \[pi/2, pi\), got .* rad"),
    (lambda: clamped_race.approach_to_rim(**RACE | {"a": 0.6}), "half-width"),
    (lambda: press_fit.Wall(r_i=1.0, r_o=1.0, E=1.0, nu=0.3), "0 <= r_i < r_o"),
    (lambda: SHAFT.stresses(0.3, p_i=0.0, p_o=1.0), r"wall \[0.4, 1.0\] m, got 0.3 m"),
    (lambda: fit(SHAFT, delta=[]), "two walls"),
    (lambda: fit(SLEEVE, SHAFT), "radius at their interface, got r_o=1.3 m, r_i=0.4 m"),
    (lambda: fit(SHAFT, SLEEVE, delta=[1e-3, 1e-3]), "1 interference"),
    (lambda: fit(SHAFT, SLEEVE, delta=0.0, p_o=-1e-3), r"0 m must exceed [\d.e-]+ m"),
    (lambda: press_fit.opening_interference(
        [SHAFT, SLEEVE], 0, interface=1, assumption="plane stress"), "an integer from 0 to 0"),
    (lambda: overlap(1.0), "overlap of the walls must be positive"),
    (lambda: overlap(0.5), "less than a tenth"),
    (lambda: overlap(0.999, p_o=-9.0), "lose contact"),
    (lambda: crown.logarithmic(0.0, **PAPER | {"K_2": 1.01}), r"K_2, .* in \(0, 1\], got 1.01"),
    (lambda: crown.logarithmic(4.6e-3, **PAPER), r"\|y\| <= l/2, got y=0.0046 m, l=0.009 m"),
    (lambda: crown.johns_gohar(0.0, half_width=0.01, **DESIGN), "less than the length, got b="),
    (lambda: crown.slice_centres(length=1.0, slices=0), "slices must be at least 1, got 0"),
    (lambda: palmgren.approach(load=-1.0, length=1.0), "load must be positive and finite, got -1"),
    *[row for by in (lamina, slices) for row in (
        (lambda by=by: pressed(by, load=None), r"exactly one of load \[N\] and appr"),
        (lambda by=by: pressed(by, load=None, approach=nan), "approach must be finite, got nan m"),
        (lambda by=by: pressed(by, gap=0.0), r"one height \[m\] per slice .* \(\)"),
        (lambda by=by: pressed(by, gap=[0.0, inf]), "gap must be finite"),
        (lambda by=by: pressed(by, gap=np.zeros((3, 5)), load=[1.0, 2.0]), "must be compatible"),
    )],
    (lambda: pressed(lamina, compliance=0.0), r"compliance of a slice .* got 0.0 m\^\(10/9\)/N"),
    (lambda: pressed(slices, kernel=np.eye(3)), r"matrix \(2, 2\) .* got shape \(3, 3\)"),
    (lambda: pressed(slices, kernel=[[2.0, 1.0], [0.5, 2.0]]), "weights must be symmetric"),
    (lambda: pressed(slices, kernel=[[1.0, 2.0], [2.0, 1.0]]), "must be positive definite"),
    (lambda: pressed(slices, kernel=lambda d, D, b: 0 * d - 1.0), "must be positive definite"),
    (lambda: slice_compliance.compliance_matrix([1.0, 2.0], compliance=1.0), r"\(n, n\), got sha"),
    (lambda: pressed(strips, load=None), r"exactly one of load \[N\] and approach"),
    (lambda: pressed(strips, gap=0.0), "one height per strip along its last axis"),
    (lambda: pressed(strips, gap=np.zeros((3, 5)), load=[1.0, 2.0]), "must have compatible shapes"),
    (lambda: pressed(strips, load=1e9), "longer than wide.*got b/l"),
    (lambda: pressed(strips, tolerance=0.0), "tolerance must lie in"),
    (lambda: strip_error.discretisation(strips_of(4), strips_of(2)), "more strips than coarse"),
    (lambda: best_crown(**ROLLER, load=3407.0, tilt=nan), "tilt must be finite, got nan rad"),
    (lambda: best_crown(**ROLLER, load=3407.0, tilt=[]), "tilt must contain at least"),
    (lambda: best_crown(**ROLLER, load=1e9), "a line contact must be longer than wide"),
    *[(lambda change=change: press_half_space(**GRID | change), message) for change, message in (
        ({"load": None}, "exactly one of load and approach"),
        ({"cell": (1.0,)}, "a cell must have two sides"),
        ({"gap": [0.0, 1.0]}, "nx by ny values"),
        ({"start": [[1.0]]}, "starting pressure must have one value per cell"),
        ({"tolerance": 0.0}, "tolerance must be positive"),
    )],
    (lambda: HalfSpace((4, 4), cell=(1.0, 1.0), E_star=1.0).press(np.zeros((4, 5)), load=1.0),
     r"gap must have one value per cell, \(4, 4\)"),
    *[(lambda change=change: press_roller(**ROLLER | {"load": 100.0, "cells": (8, 8)} | change), m)
      for change, m in (
        ({"load": None}, "exactly one of load and approach"),
        ({"crown": np.zeros(7)}, "one height per cell along"),
        ({"width": 0.0}, "width of the patch must be positive"),
    )],
    (lambda: press_roller(**ROLLER, load=100.0, cells=(8, 8)).end_load(0.1), "exceed the length"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "message"), REFUSED, ids=[message for _, message in REFUSED])
def test_contacts_that_make_no_sense_are_refused_in_one_line(call, message):
    with pytest.raises(ValueError, match=message) as refused:
        call()
    assert "\n" not in str(refused.value)
