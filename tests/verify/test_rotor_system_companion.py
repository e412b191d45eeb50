"""The companion with unlike bearings: what it tells apart, and that faults turn its rows red."""

import numpy as np
import pytest

from analytic.rotor import rotor_study, transfer_model
from tests.conftest import solved
from verify.cases.rotor.system.case import SYSTEM, RotorSystem
from verify.cases.rotor.system.companion import companion
from verify.cases.rotor.system.formulas import TransferRotor
from verify.cases.rotor.system.inputs import RPM
from verify.core.source_code import parts_of
from verify.jobs.level import Job, judge_case

pytestmark = pytest.mark.xdist_group("rotor-system")
JUDGED = 11  # four frequencies, two critical speeds of each shaft, an amplitude and two loads


@pytest.fixture(scope="module")
def beams():
    return solved(SYSTEM, RotorSystem())


def rows(beams):
    found = judge_case(Job(SYSTEM, RotorSystem(), drawn=False), beams).rows
    return [row for row in found if row.quantity.startswith("companion")]


def test_every_value_has_a_row_that_passes_beside_the_default_rotor_alone(beams):
    found = rows(beams)
    assert len({row.quantity for row in found}) == 2 * JUDGED  # each and its convergence
    assert {row.status.value for row in found} == {"PASS"}
    assert not [
        k for k in SYSTEM.analytic(RotorSystem(speed=8000 * RPM)) if k.endswith("companion")
    ]


def kept(name, change):
    """A property of springs, changed."""
    was = getattr(transfer_model.Spring, name)
    return transfer_model.Spring, name, property(lambda s: change(*was.fget(s)))


def excited(change):
    was = rotor_study.unbalance_response
    return (
        rotor_study,
        "unbalance_response",
        lambda r, n, u, excitation: was(r, n, change(u, excitation), excitation=excitation),
    )


FAULTS = {
    "deviator of damping turned round": lambda: kept("damping", lambda c, e: (c, -e)),
    "conjugate deviator of stiffness": lambda: kept("stiffness", lambda k, d: (k, np.conj(d))),
    "twice the damping": lambda: kept("damping", lambda c, e: (2 * c, 2 * e)),
    "conjugate unbalance on the shaft that turns against the other": lambda: excited(
        lambda u, e: {n: v if e > 0 else np.conj(v) for n, v in u.items()}
    ),
    "conjugate unbalance": lambda: excited(
        lambda u, _: {n: np.conj(v) for n, v in u.items()}
    ),
    "unbalances of one angle": lambda: excited(lambda u, _: {n: abs(v) for n, v in u.items()}),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
def test_a_fault_of_the_formulas_turns_amplitude_and_loads_red(fault, beams, monkeypatch):
    monkeypatch.setattr(*fault())
    red = {row.quantity for row in rows(beams) if row.status.value == "FAIL"}
    assert "companion with unlike bearings: amplitude" in red
    assert "companion with unlike bearings: load of the first support" in red
    assert "companion with unlike bearings: load of the link" in red


def each(table, **change):
    """Companions in which one part alone is changed."""
    given = {name: getattr(companion(TransferRotor), name) for name in TransferRotor.model_fields}
    parts = given[table]
    for k, part in enumerate(parts):
        new = {name: of(getattr(part, name)) for name, of in change.items()}
        if new != {name: getattr(part, name) for name in new}:
            changed = (*parts[:k], part.model_copy(update=new), *parts[k + 1 :])
            yield TransferRotor(**(given | {table: changed}))


ONE_PART = [
    pytest.param(table, change, id=f"{table} {name}")
    for table in ("supports", "links")
    for name, change in (
        ("kxy", {"kxy": lambda v: -v}), ("c_tilt", {"c_tilt": lambda _: 0.0}),
        ("cyy", {"cyy": lambda _: None}), ("c", {"c": lambda v: 2 * v}),
    )
] + [pytest.param("unbalances", {"angle": lambda v: -v}, id="unbalances angle")]  # fmt: skip


@pytest.mark.parametrize(("table", "change"), ONE_PART)
def test_every_part_is_felt_by_a_row(table, change):
    """By more than three times what a row lets pass, 1e-4."""
    base = companion(TransferRotor)
    others = list(each(table, **change))
    assert others
    for other in others:
        keys = ("amplitude", "support_load", "link_load")
        assert max(abs(getattr(other, k) / getattr(base, k) - 1) for k in keys) > 3e-4


def test_the_key_of_the_reference_holds_no_formula():
    _, modules = parts_of(SYSTEM.reference)
    assert "fem.rotor.model" in modules
    assert not [name for name in modules if name.startswith("analytic.")]
