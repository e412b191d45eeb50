"""Fixture: rows that are evidence for verdicts."""

import pytest

from verify.core.results import Kind, Row, Status


@pytest.fixture
def row():
    """Function: row of a case with a relative error and its relative expanded uncertainty."""

    def made(quantity, error, U=0.0, *, case="ring-lame", **changes):
        given = {
            "symbol": "x", "unit": "1", "kind": Kind.APPROXIMATION, "status": Status.PASS,
            "analytic": 1.0 + error, "fem": 1.0, "difference": error, "scale": 1.0, "tolerance": U,
        }  # fmt: skip
        return Row(case=case, quantity=quantity, **given | changes)

    return made
