"""Inputs of the accordion spring as a strip of finite width, with its end conditions."""

from analytic.spring.frame import Head, Tail
from verify.cases.spring.inputs import SpringInputs
from verify.core.inputs import word


class WidthInputs(SpringInputs):
    """Inputs of the accordion spring with the end conditions of head and tail."""

    head: Head = word(
        "guided", "boundary condition of the head; guided: no sideways motion and no rotation"
    )
    tail: Tail = word(
        "mid-leaf", "place at which the clamp of the tail begins: middle of its leaf, or its arc"
    )
