"""Freewheels that cannot wedge, and invalid loads, are refused in one line."""

from dataclasses import replace

import pytest

from analytic.freewheel import criterion, state, tolerance
from analytic.freewheel.geometry import InnerCam, OuterCam
from analytic.freewheel.load_path import AlternatingAxial, AxialRamp, BothAlternating

STAR = {"R": 16.5, "r": 2.5, "X": 11.39, "z": 8}
CUP = {"R_s": 10.0, "r": 2.0, "X_o": 13.9, "z": 8}
LOAD = {"T": 10.0, "F_ax": 300.0, "mu": 0.08, "n": 3, "seed": 1}

REFUSED = [
    (lambda _: InnerCam(**STAR | {"X": [11.39, 11.6, 11.7]}), r"no wedge.*X=11\.6 m"),
    (lambda _: InnerCam(**STAR | {"r": 17.0, "X": 1.0}), "roller too large"),
    (lambda _: InnerCam(**STAR | {"X": -2.6}), "flat beyond"),
    (lambda _: InnerCam(**STAR | {"z": 20}), "touch each other"),
    (lambda _: InnerCam(**STAR | {"X": 9.0}), "corner"),
    (lambda _: InnerCam(**STAR | {"z": 7.5}), "whole"),
    (lambda _: OuterCam(**CUP | {"X_o": 9.0}), "cuts the shaft"),
    (lambda _: OuterCam(**CUP | {"X_o": 14.1}), "no wedge"),
    (lambda _: OuterCam(**CUP | {"X_o": 12.0}), "corner"),
    (lambda star: replace(star, r_b=12e-3), "r_b below"),
    (lambda star: replace(star, r_b=0.0), "clamped"),
    (lambda star: replace(star, R_a=16e-3), "R_a above"),
    (lambda star: replace(star, star="disc"), "star must be one of"),
    (lambda star: state.loaded(star, -1.0), "torque"),
    (lambda _: criterion.traffic_light(1.0, red=1.2, green=1.0), "red <= green"),
    (lambda _: AxialRamp(T=1.0, F=1.0, rise=2.0, duration=1.0), "rise"),
    (lambda _: AlternatingAxial(T=1.0, F=1.0, rise=1.0, duration=2.0, frequency=0.0), "freq"),
    (lambda _: BothAlternating(T=1.0, F=-1.0, frequency=1.0, duration=2.0), "axial load"),
    (lambda star: tolerance.draw(star, {"Y": 1e-6}, **LOAD), "'Y'"),
    (lambda star: tolerance.draw(star, {}, kind="flat", **LOAD), "kind must be one of"),
    (lambda star: tolerance.first_order(star.cam, {"X": 0.0}), "above 0"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "message"), REFUSED, ids=[message for _, message in REFUSED])
def test_what_cannot_wedge_is_refused_in_one_line(star, call, message):
    with pytest.raises(ValueError, match=message) as refused:
        call(star)
    assert "\n" not in str(refused.value)
