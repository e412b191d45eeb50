"""Readings of the papers: the other reading of each turns a row red."""

import math

import pytest

from analytic.ring import lame
from analytic.spring import energy, frame
from verify.cases.ring.lame.case import LAME
from verify.cases.spring.accordion.case import ACCORDION
from verify.cases.spring.continuum.case import CONTINUUM
from verify.cases.spring.inputs import AccordionInputs
from verify.cases.spring.readings import search
from verify.papers.ledger import published

PRINTED = published("wang2023:k1-theory")
TOLERANCE = 0.0005  # half the last printed digit of 0.601


def names(rows):
    return {row.quantity for row in rows}


@pytest.fixture
def patched(monkeypatch):
    """Wrap a function of the analytic side, so that only this side reads differently."""

    def patch(module, name, wrapper):
        right = getattr(module, name)
        monkeypatch.setattr(module, name, lambda *a, **k: wrapper(right, *a, **k))

    return patch


@pytest.mark.xdist_group("ring-lame")
def test_pressure_on_the_rim_pushes_inwards(judged, red, patched):
    def pulling(right, *args, p_o=0.0, **more):
        return right(*args, p_o=-p_o, **more)

    patched(lame, "stresses", pulling)
    assert "bore hoop stress, plane stress" in names(red(judged(LAME)))


@pytest.mark.xdist_group("ring-lame")
def test_a_thin_and_a_long_ring_are_told_apart(judged, red, patched):
    other = {"plane stress": "plane strain", "plane strain": "plane stress"}

    def swapped(right, *args, ends, **more):
        return right(*args, ends=other[ends], **more)

    patched(lame, "radial_displacement", swapped)
    failed = names(red(judged(LAME)))
    assert {"bore displacement, plane stress", "bore displacement, plane strain"} <= failed


@pytest.mark.xdist_group("spring-accordion")
def test_arcs_of_eqs_1_to_9_have_the_inner_radius(judged, red, patched):
    def centre_line(right, *, r, b, **more):
        return right(r=r + b / 2, b=b, **more)

    patched(energy, "stiffness", centre_line)
    assert "stiffness by Eqs. 1-9" in names(red(judged(ACCORDION)))


@pytest.mark.xdist_group("spring-accordion")
@pytest.mark.parametrize(
    ("leaf", "offset"),
    [
        pytest.param(2.0, "b", id="2 L_1/sin α"),
        pytest.param(1.0, "h", id="h/2"),
        pytest.param(2.0, "h", id="both as printed"),
    ],
)
def test_the_leaf_length_of_eq_3_is_read_with_half_the_straight_length(
    leaf, offset, judged, red, patched
):
    h = AccordionInputs().h

    def printed(_, *, L1, r, b, alpha):
        half = (b if offset == "b" else h) / 2
        return leaf * L1 / math.sin(alpha) + 2 * (r + half) / math.tan(alpha)

    patched(energy, "leaf_length", printed)
    assert "stiffness by Eqs. 1-9" in names(red(judged(ACCORDION)))


@pytest.mark.xdist_group("spring-accordion")
def test_signs_of_eq_3_alternate_from_unit_to_unit(judged, red, patched):
    patched(energy, "_sign", lambda _right, _i: 1)
    assert "stiffness by Eqs. 1-9" in names(red(judged(ACCORDION)))


@pytest.mark.xdist_group("spring-accordion")
def test_the_first_couple_of_eq_3_is_that_of_the_head_s_apex(judged, red, patched):
    def without_radius(right, *, L1, r, **more):
        return tuple(T - r for T in right(L1=L1, r=r, **more))

    patched(energy, "apex_moments", without_radius)
    assert "stiffness by Eqs. 1-9" in names(red(judged(ACCORDION)))


@pytest.mark.xdist_group("spring-accordion")
@pytest.mark.parametrize("end", ["head", "tail"])
def test_the_ends_of_the_spring_are_told_apart(end, judged, red, patched):
    other = {"free": "hinged", "hinged": "guided", "guided": "hinged"}
    other |= {"arc": "mid-leaf", "mid-leaf": "arc"}

    def swapped(right, **more):
        return right(**more | {end: other[more[end]]} if end in more else more)

    patched(frame, "stiffness", swapped)
    failed = names(red(judged(ACCORDION)))
    assert {n for n in failed if n.startswith("stiffness, head")} >= {
        f"stiffness, head {h}, tail at {t}: curved elements"
        for h in ("free", "guided")
        for t in ("arc", "mid-leaf")
    }


@pytest.mark.xdist_group("spring-continuum")
@pytest.mark.parametrize(
    "change",
    [
        pytest.param(lambda q: {"radius": q.r}, id="inner radius for the centre line"),
        pytest.param(lambda _q: {"plane_strain": False}, id="narrow strip for a wide one"),
    ],
)
def test_the_strip_of_the_continuum_is_told_from_another(change, judged, red, patched):
    def other(right, **more):
        return right(**more | change(AccordionInputs()))

    patched(frame, "stiffness", other)
    assert "stiffness, thin frame, plane strain" in names(red(judged(CONTINUUM)))


def test_one_reading_alone_gives_the_printed_stiffness():
    readings = search(AccordionInputs())
    met = [x for x in readings if abs(x.k / 1e3 - PRINTED.value) <= TOLERANCE]
    assert [x.is_adopted for x in met] == [True]
    # by the direct quadrature of the search and by the closed forms of the formula
    adopted = energy.stiffness(
        n=10, b=0.1, h=56.0, r=0.45, L1=11.6, alpha=math.radians(80), E=206e3
    )
    assert met[0].k / 1e3 == pytest.approx(float(adopted), rel=1e-12)
    assert min(x.k for x in readings) / 1e3 < 0.02  # what the garbled forms give, literally
    # Eq. 3's second line alone as printed: the ledger says 0.5914
    (literal,) = [
        x.k / 1e3
        for x in readings
        if (x.leaf, x.offset, x.radius, x.signs, x.start)
        == ("L_1/sin α", "r + b/2", "r", "M_2 as printed", "F (L_1/2 + r)")
    ]
    assert literal == pytest.approx(0.5914, abs=5e-5)
