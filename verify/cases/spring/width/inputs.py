"""Inputs of the accordion spring as a strip of finite width, with its end conditions."""

from analytic.spring.frame import Head, Tail
from verify.cases.spring.inputs import SpringInputs
from verify.core.inputs import word


class WidthInputs(SpringInputs):
    """The accordion spring between its head and the support of its tail."""

    head: Head = word(
        "guided", "boundary condition of the head: guided, neither sideways motion nor rotation"
    )
    tail: Tail = word(
        "mid-leaf", "where the clamp of the tail begins: in its middle, or at its arc"
    )
