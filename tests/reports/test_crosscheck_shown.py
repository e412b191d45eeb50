"""Second solvers on the page, in the PDF, in results.json and as a table."""

import csv
import io
import json
from dataclasses import replace

import jsonschema
import pytest

from reports.crosscheck import counts_in_words, crosscheck_data, left_out_data
from reports.crosscheck_table import crosscheck_csv
from reports.html import page
from reports.pdf_data import document
from reports.records import report_record
from reports.rows import rows_csv
from reports.second import COLUMNS, seconds
from tests.reports.conftest import plain_text, section
from verify.core.results import Crosscheck, CrossState, Report

AGREES = Crosscheck(
    case="ring-lame", problem="ring-lame, plane strain", what="a quarter & more",
    quantity="bore displacement", row="ring-lame/bore displacement", symbol="u_r", unit="µm",
    solver="calculix", version="2.20", date="2026-11-22", state=CrossState.AGREES,
    ours=21.7672, theirs=21.7673, difference=4.6e-6, allowed=5e-5, why="six printed digits",
    seconds=(0.11, 0.52), unknowns=5522,
)  # fmt: skip
OUTSIDE = replace(AGREES, quantity="rim", row="", state=CrossState.OUTSIDE, difference=0.1)
STALE = Crosscheck(
    case="ring-lame", problem="ring-lame, plane stress", what="another", quantity="", row="",
    symbol="", unit="1", solver="calculix", state=CrossState.MISSING,
    why="not measured for the present code: run `make crosscheck`",
)  # fmt: skip
ALONE = replace(
    STALE, problem="ring-lame", what="no second solver", solver="", state=CrossState.ALONE,
    why="nobody's",
)  # fmt: skip


@pytest.fixture(scope="module")
def checked(wordy) -> Report:
    """A case with a row that a second solver took too, and problems that belong to no row."""
    row = replace(wordy.rows[0], case="ring-lame", quantity="bore displacement", unit="µm")
    case = replace(wordy.cases[0], id="ring-lame", name="", rows=(row,), title="Ring")
    other = replace(AGREES, quantity="a sum")  # not that row's
    return replace(wordy, name="", cases=(case,), tables=(), errata=(),
                   crosschecks=(AGREES, OUTSIDE, other, STALE))  # fmt: skip


def test_page_and_pdf_have_a_separate_table_and_a_row_leads_to_its_line(checked):
    html, text = page(checked, {}), section(checked, "crosscheck")
    assert "2 of 3 numbers agree; 1 problem has no current result" in text
    assert "calculix 2.20: 3 numbers of 1 problem; largest difference +10\u202f%" in text
    assert '(<a href="#cross-1">ring-lame, rim</a>)' in text
    assert "a quarter &amp; more" in text
    assert "5522 unknowns, solved by the project in 0.11 s, by the second solver in 0.52 s" in text
    assert text.count('class="is-fail"') == 1
    assert "Not measured for the present code" in text
    assert '<a href="#crosscheck">' in html
    cell = html.partition('<td role="cell" class="n fe')[2].partition("</td>")[0]
    assert cell.count('href="#cross-') == cell.count('href="#cross-0"') == 1
    assert (
        "</a>: 21.7673, difference from this project on the same mesh +0.00046\u202f%, "
        "computing time 0.52 s<" in cell
    )
    assert "5522 unknowns: 21.7673 µm; project: 21.7672 µm" in cell
    assert [f'<tr id="cross-{i}"' in text for i in range(4)] == [True, True, True, False]
    (first,) = crosscheck_data((AGREES, OUTSIDE))
    assert [plain_text(row[-1]) for row in first["rows"]] == [
        "+0.00046\u202f% (0.0050\u202f%)", "+10\u202f% (0.0050\u202f%) !",
    ]  # fmt: skip
    data = document(checked, {})
    (sentence,) = data["crosschecks_left"]
    assert plain_text(sentence).startswith("Not measured for the present code")
    assert data["crosschecks_told"] == counts_in_words(checked.crosschecks)


def test_several_numbers_that_agree_have_one_sentence_at_the_head_of_a_case(checked):
    many = [replace(AGREES, quantity=f"sum {i}", difference=i * 1e-6) for i in range(6)]
    head = page(replace(checked, crosschecks=tuple(many)), {}).partition("Second solver, ")[2][:900]
    assert (
        '<a href="#cross-5">6 numbers</a>, '
        "largest difference from this project on the same mesh "
        "+0.00050\u202f%" in head
    )
    assert ", computing time 0.52 s." in head
    outside = replace(many[0], state=CrossState.OUTSIDE)
    head = page(replace(checked, crosschecks=(outside, *many[1:])), {})
    head = head.partition("Second solver, ")[2].partition("</p>")[0]
    assert head.count("</a>: difference from this project on the same mesh +") == 5
    assert " (more than allowed), computing" in head


def test_a_case_that_no_solver_takes_has_its_reason(checked):
    text = section(replace(checked, crosschecks=(AGREES, ALONE)), "crosscheck")
    assert "1 case has no second solver (reasons below)" in text
    assert "()" not in text
    (sentence,) = left_out_data([ALONE])
    assert plain_text(sentence) == "Nobody's: ring-lame, no second solver."


def test_tables_and_records_have_the_second_solver_beside_the_row(checked, schema):
    record = json.loads(json.dumps(report_record(checked)))
    for one in record["crosschecks"]:
        jsonschema.validate(one, {"$ref": "#/$defs/crosscheck", "$defs": schema["$defs"]})
    assert record["crosschecks"][3]["ours"] is None
    (row,) = record["rows"]
    (one,) = row["second_solvers"]
    jsonschema.validate([one], schema["$defs"]["row"]["properties"]["second_solvers"])
    assert one["difference"] == 4.6e-6
    found = seconds(checked.crosschecks).rows
    for given, expected in (((found,), ["calculix", "21.7673", "4.6e-06", "0.52"]), ((), [""] * 4)):
        (line,) = csv.DictReader(io.StringIO(rows_csv(checked.rows, *given).lstrip("\ufeff")))
        assert [line[name] for name in COLUMNS] == expected
    text = crosscheck_csv([replace(AGREES, why="=1+1"), OUTSIDE, STALE])
    assert text.startswith("\ufeff")  # as rows.csv and budget.csv
    first, _, last = csv.DictReader(io.StringIO(text.removeprefix("\ufeff")))
    assert (first["why"], first["seconds_there"]) == ("'=1+1", "0.52")
    assert last["state"] == "not measured"
