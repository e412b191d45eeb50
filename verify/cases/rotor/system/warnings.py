"""Warnings on a rotor that a user described."""

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise
from typing import NamedTuple

from verify.cases.rotor.description import SegmentInputs
from verify.cases.rotor.system.inputs import RPM
from verify.cases.rotor.system.transfer import DescribedRotor

AXIAL_GAP = 1e-4  # m, largest axial distance between the two nodes of a bearing between shafts
TOUCH = 1e-9  # m, largest overlap that rounded positions can cause
RIGID = 0.5  # damping times speed over stiffness; above it, damping supports a shaft
LISTED = 4  # largest number of parts that a warning names


class Placed(NamedTuple):
    """Segment number `k` between two axial positions [m]."""

    k: int
    low: float
    high: float
    segment: SegmentInputs


def warnings(q: DescribedRotor) -> Sequence[str]:
    return [*_links(q), *_through(q), *_damping(q), *_short(q), *_steps(q), *_speed(q)]


def placed(q: DescribedRotor) -> list[Placed]:
    """Segments of each shaft with their axial positions."""
    found = []
    for shaft in q.shafts:
        at = shaft.start
        for k, s in enumerate(q.segments, start=1):
            if s.shaft == shaft.name:
                found.append(Placed(k, at, at + s.length, s))
                at += s.length
    return found


def _links(q: DescribedRotor) -> Iterator[str]:
    for k, link in enumerate(q.links, start=1):
        gap = q.places[link.node - 1] - q.places[link.to - 1]
        if abs(gap) > AXIAL_GAP:
            yield (
                f"links[{k}] joins nodes at an axial distance of {abs(gap) * 1e3:.4g} mm: correct "
                "the input start of a shaft"
            )


def _through(q: DescribedRotor) -> Iterator[str]:
    """Warnings if the inner of two coaxial shafts does not fit into the bore of the outer."""
    met = []
    for a, b in combinations(placed(q), 2):
        over = min(a.high, b.high) - max(a.low, b.low)
        inner, outer = (a, b) if a.segment.d_o <= b.segment.d_o else (b, a)
        fits = inner.segment.d_o <= outer.segment.d_i
        if a.segment.shaft != b.segment.shaft and over > TOUCH and not fits:
            met.append(
                f"segments[{inner.k}], d_o = {inner.segment.d_o * 1e3:.4g} mm, in the bore of "
                f"segments[{outer.k}], d_i = {outer.segment.d_i * 1e3:.4g} mm, over "
                f"{over * 1e3:.4g} mm"
            )
    if met:
        more = f"; and {len(met) - LISTED} more" if len(met) > LISTED else ""
        yield f"shafts overlap radially: {'; '.join(met[:LISTED])}{more}"


def _damping(q: DescribedRotor) -> Iterator[str]:
    springs = [
        (f"{table}[{k}]", s)
        for table, entries in (("supports", q.supports), ("links", q.links))
        for k, s in enumerate(entries, start=1)
    ]
    if q.unbalances and not any(s.c or s.cyy or s.c_tilt for _, s in springs):
        yield "no bearing has damping: amplitudes at critical speeds are unbounded"
    for name, s in springs:
        across = s.c, s.k
        along_y = s.c if s.cyy is None else s.cyy, s.k if s.kyy is None else s.kyy
        if any(c * q.speed_to > RIGID * k for c, k in (across, along_y)):
            yield (
                f"{name}: damping times the highest operating speed exceeds {RIGID:g} times the "
                "stiffness, so that the bearing acts as rigid; frequencies and critical speeds are "
                "computed without damping"
            )


def _short(q: DescribedRotor) -> Iterator[str]:
    """Warnings on short lengths of constant diameter; adjacent equal segments count as one."""
    runs: list[list[Placed]] = []
    for s in placed(q):
        last = runs[-1][-1].segment if runs else None
        alike = last is not None and (last.shaft, last.d_o) == (s.segment.shaft, s.segment.d_o)
        if alike:
            runs[-1].append(s)
        else:
            runs.append([s])
    short = [run for run in runs if run[-1].high - run[0].low < run[0].segment.d_o / 10]
    if short:
        names = ", ".join(f"segments[{run[0].k}]" for run in short[:LISTED])
        more = f" and {len(short) - LISTED} more" if len(short) > LISTED else ""
        verb = "is" if len(short) == 1 else "are"
        yield (
            f"{names}{more} {verb} shorter than a tenth of the diameter: beam theory does not apply"
        )


def _steps(q: DescribedRotor) -> Iterator[str]:
    steps = [
        a.k for a, b in pairwise(placed(q))
        if a.segment.shaft == b.segment.shaft
        and max(a.segment.d_o, b.segment.d_o) > 1.5 * min(a.segment.d_o, b.segment.d_o)
    ]  # fmt: skip
    if steps:
        yield (
            f"the diameter changes by half or more after segments[{steps[0]}]: beam theory "
            "overestimates the frequencies of stepped shafts, by up to about 9 %"
        )


def _speed(q: DescribedRotor) -> Iterator[str]:
    if q.speed > 1.2 * q.speed_to or q.speed < 0.8 * q.speed_from:
        yield f"speed = {q.speed / RPM:.5g} r/min is not within the operating range"
