"""Rings (Lamé) and the accordion spring (Wang 2023): the other reading fails a row of its case."""

import math

import pytest

from analytic.spring import energy, frame
from verify.cases.spring.accordion.case import ACCORDION
from verify.cases.spring.continuum.case import CONTINUUM
from verify.cases.spring.inputs import AccordionInputs
from verify.cases.spring.readings import search
from verify.papers.ledger import published

EQS = "stiffness by Eqs. 1-9"
THIN = "stiffness, thin frame, plane strain"
OTHER = {
    "plane stress": "plane strain", "plane strain": "plane stress",
    "arc": "mid-leaf", "mid-leaf": "arc",
}  # fmt: skip


def exchanged(name):
    return lambda right: lambda *a, **k: right(*a, **k | {name: OTHER[k[name]]} if name in k else k)


def leaf(times, offset):
    """Eq. 3's length of a leaf with `times` L_1/sin α, and half of b or h at its ends."""
    half = getattr(AccordionInputs(), offset) / 2
    return lambda _: (
        lambda *, L1, r, b, alpha: times * L1 / math.sin(alpha) + 2 * (r + half) / math.tan(alpha)
    )


def centre_line(right):
    return lambda *, r, b, **more: right(r=r + b / 2, b=b, **more)


def without_radius(right):
    return lambda *, L1, r, **more: tuple(T - r for T in right(L1=L1, r=r, **more))


READINGS = [
    (ACCORDION, EQS, energy, "stiffness", centre_line, "arcs of the centre line"),
    (ACCORDION, EQS, energy, "leaf_length", leaf(1.0, "h"), "h/2"),
    (ACCORDION, EQS, energy, "_sign", lambda _: lambda _i: 1, "signs that do not alternate"),
    (ACCORDION, EQS, energy, "apex_moments", without_radius, "the couple of a straight end"),
    (ACCORDION, "stiffness, head free, tail clamped at arc: curved elements", frame, "stiffness",
     exchanged("tail"), "the tail in the middle of a leaf"),
    (CONTINUUM, THIN, frame, "stiffness", lambda f: lambda **k: f(
        **k | {"radius": AccordionInputs().r}), "the inner radius"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("case", "row", "owner", "name", "fault"),
    [pytest.param(*one, id=f"{one[0].id}: {what}") for *one, what in READINGS],
)
def test_another_reading_fails_a_row(case, owner, name, fault, row, fails):
    assert fails(case, owner, name, fault, row)


def test_one_reading_alone_gives_the_printed_stiffness():
    readings = search(AccordionInputs())
    printed = published("wang2023:k1-theory").value
    met = [x for x in readings if abs(x.k / 1e3 - printed) <= 0.0005]  # half of its last digit
    assert [x.is_adopted for x in met] == [True]
    # by the direct quadrature of the search and by the closed forms of the formula
    adopted = energy.stiffness(
        n=10, b=0.1, h=56.0, r=0.45, L1=11.6, alpha=math.radians(80), E=206e3
    )
    assert met[0].k / 1e3 == pytest.approx(float(adopted), rel=1e-12)
    # Eq. 3's second line alone as printed: the ledger has 0.5914
    (literal,) = [
        x.k / 1e3 for x in readings
        if (x.leaf, x.offset, x.radius, x.signs, x.start)
        == ("L_1/sin α", "r + b/2", "r", "M_2 as printed", "F (L_1/2 + r)")
    ]  # fmt: skip
    assert literal == pytest.approx(0.5914, abs=5e-5)
