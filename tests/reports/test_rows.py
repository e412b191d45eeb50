"""rows.csv: what spreadsheets make of it."""

import csv
import io
from dataclasses import replace

import pytest

from reports.rows import rows_csv


def read(text):
    return list(csv.DictReader(io.StringIO(text.removeprefix("\ufeff"))))


@pytest.mark.parametrize("start", ["=1+1", "-2+3", "@SUM(A1)"])
def test_no_text_is_a_formula(report, start):
    row = replace(report.rows[0], quantity=start, reason=start)
    (cells,) = read(rows_csv([row]))
    assert cells["quantity"] == cells["reason"] == f"'{start}"


def test_negative_numbers_remain_numbers(report):
    row = replace(report.rows[0], analytic=-1.5, fem=-1.0, scale_name="")
    (cells,) = read(rows_csv([row]))
    assert float(cells["analytic"]) == -1.5
    assert float(cells["difference"]) == -0.5  # formula less reference
    assert float(cells["difference_percent"]) == 50.0  # the formula has the larger magnitude
    assert cells["percent_of"] == "reference"


def test_a_carriage_return_ends_no_line(report):
    row = replace(report.rows[0], reason="one\rtwo\nthree\x07")
    (cells,) = read(rows_csv([row]))
    assert cells["reason"] == "one two\nthree\ufffd"
