"""Parts of the table of solvers."""

import sys

import pytest

from benchmarks import ours, ours_contact, rotor
from benchmarks.processes import measured
from benchmarks.solvers import Run, line
from fem.rotor.response import unbalance_response


def test_a_process_reports_its_seconds_and_memory():
    idle = measured([sys.executable, "-c", "import time; time.sleep(0.3); print('done')"])
    assert idle.output == "done\n"
    assert idle.wall > 0.3 > idle.cpu
    # the kernel counts pages in batches: some MB of 400 may be missing
    large = measured([sys.executable, "-c", "x = bytearray(400 << 20); x[::4096] = x[::4096]"])
    assert large.peak > idle.peak + 380
    with pytest.raises(RuntimeError, match="of itself"):
        measured([sys.executable, "-c", "raise SystemExit('of itself')"])


def test_a_row_has_ratios_of_processor_seconds_and_the_limit():
    here = [Run(1e-5, 9.0, cpu, 80.0, 0.5) for cpu in (1.0, 2.0, 4.0)]
    there = [Run(2e-5, 9.0, 8.0, 300.0)] * 3
    cells = [cell.strip() for cell in line("ring", "calculix", 100, here, there).split("|")]
    assert cells[3:7] == ["1.0e-05, calculix 2.0e-05", "1, 2, 4", "8, 8, 8", "2, 4, 8"]
    assert cells[9] == "0.5 (25 %), at most 16.0"


def test_the_refined_amplitudes_are_nearer_than_any_solver_s():
    own, _ = rotor.pair(unlike=True, damped=True)
    found = unbalance_response(own, rotor.FINE, rotor.UNBALANCES).q.T
    assert 1e-15 < rotor.deviation(found, rotor.refined(own)) < 1e-12


def test_what_is_timed_is_there():
    for table in (ours.STAGES, ours_contact.SET_UP, ours_contact.STEP):
        for stage, (owner, names) in table.items():
            assert all(callable(getattr(owner, name)) for name in names), stage
    stages: dict[str, float] = {}
    with ours.timed(stages, ours.STAGES):
        ours.solve_ring(ours.ring_mesh("triangles", 28))
    assert set(stages) == set(ours.STAGES)
