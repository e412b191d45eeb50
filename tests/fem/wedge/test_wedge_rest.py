"""Steps to rest, without finite elements: what undoes a motion ends it."""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.errors import NotFoundError
from fem.wedge.rest import STILL, Unrest, at_rest, core_motion


@dataclass
class Turned:
    """A body that moves by a share of how far both surfaces are off 3 and -2 mm."""

    drags: tuple[float, float]
    slides: bool = False

    @property
    def solution(self):
        return SimpleNamespace(slides=self.slides)

    def unrest(self, undone=0.9):
        off = self.drags[0] - 3e-3, self.drags[1] + 2e-3
        drags = tuple(d - undone * o for d, o in zip(self.drags, off, strict=True))
        return Unrest(max(map(abs, off)), 1e-3, drags)


def test_drags_are_improved_until_the_body_moves_by_next_to_nothing():
    state = at_rest(Turned, (0.0, 0.0), Turned.unrest, body="roller", most=12)
    assert state.drags == pytest.approx((3e-3, -2e-3), abs=STILL * 1e-3)


def test_a_body_that_never_rests_has_no_state():
    with pytest.raises(NotFoundError, match=r"the roller still moves by 3\.0e-03 m after 4 steps$"):
        at_rest(Turned, (0.0, 0.0), lambda s: s.unrest(0.0), body="roller", most=4)


def test_where_every_node_slips_the_error_says_so():
    def slides(drags):
        return Turned(drags, slides=True)

    with pytest.raises(NotFoundError, match="every node of a contact slips"):
        at_rest(slides, (0.0, 0.0), lambda s: s.unrest(0.0), body="roller", most=1)


def test_the_core_of_a_rigid_motion_says_its_shift_and_turn():
    def at(x):
        return SimpleNamespace(u=np.array([[1e-6], [-2e-6]]) + 1e-4 * np.array([-x[1], x[0]]))

    solution = SimpleNamespace(plane=SimpleNamespace(at=at))
    u, turn = core_motion(solution, (0.02, 0.01), 5e-3)
    assert turn == pytest.approx(1e-4, rel=1e-9)
    assert u.mean(axis=1) == pytest.approx([1e-6 - 1e-6, -2e-6 + 2e-6], abs=1e-18)
