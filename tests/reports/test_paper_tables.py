"""The rendered tables of the papers: each value in the row and column of its number."""

import re
from html import unescape
from typing import NamedTuple

import pytest

from reports import formats
from reports.html import page
from reports.paper_rows import MOST_CLAIMS, printed_row, printed_table, used_as_inputs
from reports.pdf_data import document
from tests.reports.conftest import plain_text
from verify.app.report import make_report
from verify.cases.registry import find
from verify.core.results import PaperCell, PaperClaim, PaperTable, Report, Status

pytestmark = pytest.mark.slow("the cases of the tables are judged first")

HEADERS = {
    ("huang2018", "Table 1"): ["Parameter", "Value", "Parameter", "Value"],
    ("huang2018", "Table 2"):
        ["Actual value [MPa]", "Predictive value [MPa]", "Relative error", "MSE"],
    ("wang2023", "Table 1"): ["Spring constant [N/mm]", "Theory", "FEA", "Experiment"],
}  # fmt: skip
FURTHER = "further comparisons with "
OURS = ["FE (u)", "Compared in"]
# Values of the suite, with the printed row and column that each is to reproduce.
CLAIMING = ("ring-loads-outer", "sprag-wedge", "sprag-optimum", "spring-accordion", "spring-width")


class Block(NamedTuple):
    """A printed row and the lines below it, cell by cell."""

    printed: list[str]
    below: list[list[str]]


def words(markup: str) -> str:
    """The text of a cell, with powers and indices as the papers' copies have them."""
    raised = re.sub(r"<sup>(.*?)</sup>", r"^\1", markup).replace("−", "-")
    return unescape(re.sub("<.*?>", "", re.sub(r"<sub>(.*?)</sub>", r"_\1", raised))).strip()


def cells(row: str) -> list[str]:
    return [words(cell) for cell in re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row, re.DOTALL)]


@pytest.fixture(scope="module")
def report(of_paper) -> Report:
    """The cases whose rows or inputs are numbers of the tables."""
    cases = [find(name) for name in CLAIMING]
    return make_report([of_paper(case) for case in cases], cases, 1.0)


@pytest.fixture(scope="module")
def rendered(report) -> dict[tuple[str, str], tuple[list[str], list[Block]]]:
    """Header and blocks of each table on the page, with the lines of its second part."""
    text = page(report, {})
    text = text[text.index('<section id="tables">') : text.index('<section id="errata">')]
    found = {}
    for name, table in re.findall(
        r'aria-label="((?:further comparisons with )?\w+ Table \d)"><table(.*?)</table>',
        text, re.DOTALL,
    ):  # fmt: skip
        head, *bodies = [re.findall(r"<tr>.*?</tr>", part, re.DOTALL)
                         for part in re.split("<tbody>", table)]  # fmt: skip
        blocks = [Block(cells(rows[0]), [cells(row) for row in rows[1:]]) for rows in bodies]
        paper, _, number = name.removeprefix(FURTHER).partition(" ")
        if name.startswith(FURTHER):
            for more in blocks:
                printed = more.printed[: len(HEADERS[paper, number])]
                first = next(
                    b for b in found[paper, number][1] if b.printed[: len(printed)] == printed
                )
                assert len(first.below) == MOST_CLAIMS
                first.below.extend(more.below)
        else:
            found[paper, number] = cells(head[0]), blocks
    return found


@pytest.mark.parametrize("which", HEADERS, ids=" ".join)
def test_every_printed_cell_and_every_value_below_it_stand_in_their_column(which, report, rendered):
    header, blocks = rendered[which]
    table = next(t for t in report.tables if (t.paper, t.name) == which)
    columns = len(HEADERS[which])
    assert header[:columns] == HEADERS[which]
    assert header[columns:] in ([], OURS[1:], OURS)
    lines = [{claim.row for cell in row for claim in cell.rows} for row in table.rows]
    for row, block in zip(table.rows, blocks, strict=True):
        assert block.printed[:columns] == [cell.text for cell in row]
        expected = {}
        for k, cell in enumerate(row):
            for claim in cell.rows:
                if sum(claim.row in line for line in lines) == 1:  # others stand below the table
                    line = expected.setdefault(claim.row, [""] * columns)
                    line[k] = words(f"{formats.small(claim.analytic)}{off(claim, cell)}")
        claimed = [line for line in block.below if "input" not in line]
        assert sorted(line[:columns] for line in claimed) == sorted(expected.values())
        for line in claimed:
            names = [id_ for id_, values in expected.items() if values == line[:columns]]
            assert any(line[-1].endswith(plain(id_.partition("/")[2])) for id_ in names)


def off(claim: PaperClaim, cell: PaperCell) -> str:
    """The difference from a printed number, as it stands in brackets after a value."""
    if claim.analytic is None or not re.fullmatch(r"-?[\d.]+", cell.text) or not float(cell.text):
        return ""
    return f" ({formats.percents(claim.analytic / float(cell.text) - 1, signed=True)})"


def test_a_row_on_a_whole_column_stands_once_below_the_table():
    column, own = (
        PaperClaim(row=row, status=Status.PASS, analytic=1.0, fem=None, u=None)
        for row in ("a/column", "a/single")
    )
    cells = [PaperCell(text="1", rows=(column,), errata=("both",)),
             PaperCell(text="2", rows=(column, own), errata=("both", "alone"))]  # fmt: skip
    table = PaperTable(paper="p", name="Table 1", caption="", header=("x",),
                       rows=tuple((cell,) for cell in cells))  # fmt: skip
    shown = printed_table(table)
    assert [claim.row for claim in shown.common] == ["a/column"]
    assert [[claim.row for claim in row.claims] for _, row in shown.rows] == [[], ["a/single"]]
    assert [list(row.errata) for _, row in shown.rows] == [[], ["alone"]]
    assert shown.is_compared
    assert not shown.has_references


def test_a_row_has_a_number_in_each_column_below_it_before_others():
    claims = [
        PaperClaim(row=f"a/{name}", status=status, analytic=value, fem=None, u=None)
        for name, status, value in (
            ("none", Status.CALIBRATED, None), ("first", Status.SHOWN, 1.0),
            ("second", Status.SHOWN, 2.0), ("third", Status.SHOWN, 3.0),
            ("other column", Status.PASS, 4.0),
        )
    ]  # fmt: skip
    row = printed_row([PaperCell(text="1", rows=tuple(claims[:4])),
                       PaperCell(text="2", rows=(claims[4],))])  # fmt: skip
    assert [c.name for c in row.first] == ["first", "second", "other column"]
    assert [c.name for c in row.further] == ["none", "third"]
    failed = PaperClaim(row="a/failed", status=Status.FAIL, analytic=None, fem=None, u=None)
    row = printed_row([PaperCell(text="1", rows=(*claims[:4], failed))])
    assert [c.name for c in row.first] == ["failed", "first", "second"]
    assert [c.name for c in printed_row([PaperCell(text="1", rows=claims[:1])]).first] == ["none"]


def plain(quantity: str) -> str:
    return words(str(formats.prose(quantity)))


def test_inputs_that_repeat_a_printed_number_stand_below_the_table(report, rendered):
    assert set(rendered) == set(HEADERS)
    _, blocks = rendered["huang2018", "Table 1"]
    assert not any("ring-loads" in cell for block in blocks for cell in block.printed)
    table = next(t for t in report.tables if (t.paper, t.name) == ("huang2018", "Table 1"))
    used = used_as_inputs(table)
    assert sum(len(cell.inputs) > 0 for cells in table.rows for cell in cells) == len(used) > 5
    assert "input n in ring-loads-outer; input z in sprag" in used[0].words
    text = page(report, {})
    assert all(str(formats.prose(one.words)) in text for one in used)


def test_the_pdf_has_the_same_columns(report, rendered):
    (table,) = (t for t in document(report, {})["ledgers"]["tables"] if "Wang" in t["name"])
    for block, row in zip(rendered["wang2023", "Table 1"][1], table["rows"], strict=True):
        claimed = [line[:4] for line in block.below if "input" not in line]
        expected = [
            [plain_text(runs).replace("−", "-") for runs in c["formulas"]] for c in row["claims"]
        ]
        assert sorted(claimed) == sorted(expected)
