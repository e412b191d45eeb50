"""Beams that wrap discs: what lies on carries no pressure, what lifts off presses."""

import pytest

from fem.beam.large import LargeFrame
from fem.beam.section import Section
from fem.beam.touching import Obstacle
from fem.beam.touching_rigid import Disc
from tests.fem.beam.touching_shapes import line

L, EI, COUNT = 1.0, 1.0, 20


def test_a_cantilever_wraps_a_disc_up_to_where_its_moment_bends_it_as_much():
    radius, b = 8.0, 0.002
    # lies on up to L - EI/(F R), R that of its own line; there it bends as the disc does
    EA = 12 * EI / b**2
    points, elements = line((0, 0), (L, 0), COUNT)
    disc = Obstacle(points, elements, Disc((0, -radius - b / 2), radius), thickness=b, EA=EA)
    frame = LargeFrame(
        points, elements, sections=Section(EA=EA, EI=EI, GA=EA), supports={0: "xyr"}, terms=[disc]
    )
    moment = EI / (radius + b / 2)
    force = 2 * moment / L
    last = frame.under_loads({2 * COUNT: (0.0, -force, 0.0)}, [0.25, 0.5, 0.75, 1.0]).last
    record = disc.record
    lift = record.at[record.normal > 0.05 * force, 0].max()
    assert lift == pytest.approx(L / 2, abs=L / COUNT)
    # shear and where in an element it lifts off: some hundredths of the arm
    arm = last.u[-1, 0] + L - lift
    assert force * arm == pytest.approx(moment, rel=0.06)
    # the element at the clamp is bent a little less
    assert last.reactions[0, 2] == pytest.approx(moment, rel=0.04)
    lying = (record.at[:, 0] > 0.1 * L) & (record.at[:, 0] < lift - 3 * L / COUNT)
    assert record.normal[lying].max(initial=0.0) < 0.02 * force
    assert record.penetration < 1e-3 * b
