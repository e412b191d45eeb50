"""The tables of the papers: as printed, every number in the ledger, and comments on numbers."""

import re

import pytest
from pydantic import ValidationError

from verify.cases.registry import CASES
from verify.core import units
from verify.core.results import Status
from verify.papers.ledger import Paper, papers
from verify.papers.paper_tables import claiming_inputs, paper_tables
from verify.papers.tables import PrintedTable

SPRING = next(case for case in CASES if case.id == "spring-accordion")

# Copied from the papers cell by cell, not from the ledger.
WANG_1 = """
k_1 | 0.601 | 0.613 | 0.610
k_2 |       | 0.749 | 0.708
"""
HUANG_1 = """
nbg       | 12    | m_g [kg]        | 1.8×10^-3
R_id [mm] | 7.21  | I_1 [kg m^2]    | 1.97×10^-4
R_i [mm]  | 11.11 | I_bi [kg m^2]   | 1.41×10^-3
R_e [mm]  | 19.44 | I_be [kg m^2]   | 1.41×10^-3
R_ed [mm] | 26.23 | I_g [kg m^2]    | 1.18×10^-8
r_i1 [mm] | 4.02  | K_r [N m/rad]   | 0.01
r_i2 [mm] | 4.02  | C_rl [N m s/rad] | 0.1
r_i3 [mm] | 4.02  | C_f [N m]       | 1.66×10^-2
"""
HUANG_2 = """
3124.2 | 3167.9 | 1.38 | 14.08
3000.0 | 3050.1 | 1.64 | 10.86
3002.4 | 3015.9 | 0.45 | 1.36
2994   | 2994   | 0    | 0
3011.3 | 3001.3 | 0.33 | 3.55
3080.3 | 3084.7 | 0.14 | 5.3
3038.1 | 3047.3 | 0.3  | 5.15
3027.1 | 3044.5 | 0.57 | 15.79
3038.2 | 3032.5 | 0.19 | 3.01
3079.2 | 3073.8 | 0.17 | 3.01
"""
PRINTED = {
    ("wang2023", "Table 1"): WANG_1,
    ("huang2018", "Table 1"): HUANG_1,
    ("huang2018", "Table 2"): HUANG_2,
}


@pytest.fixture(scope="module")
def tables(judged):
    return {(t.paper, t.name): t for t in paper_tables([judged(SPRING)], claiming_inputs(CASES))}


def test_a_table_reads_as_it_is_printed_and_its_units_are_those_of_its_values(tables):
    for which, text in PRINTED.items():
        shown = [[cell.text for cell in row] for row in tables[which].rows]
        assert shown == [[c.strip() for c in line.split("|")] for line in text.strip().split("\n")]
    for table in tables.values():
        for row in table.rows:
            for k, cell in enumerate(row):
                near = [row[k - 1].text if table.header[0] == "Parameter" else table.header[k]]
                near += [table.header[0]] if table.paper == "wang2023" else []
                named = [m[1] for text in near if (m := re.search(r"\[(.+)\]", text))]
                if cell.value is not None and named:
                    assert units.factor(named[0]) == units.factor(cell.unit)


TABLE = {"name": "Table 1", "caption": "x", "header": ["a", "b"], "rows": [["k", "=k"]]}


def wang(**change):
    """The spring paper with its only table changed."""
    raw = next(p for p in papers() if p.key == "wang2023").model_dump()
    return raw | {"tables": [raw["tables"][0] | change]}


ROWS = wang()["tables"][0]["rows"]


def test_tables_and_values_that_differ_are_refused():
    PrintedTable.model_validate(TABLE)
    Paper.model_validate(wang())
    for raw, message in (
        (TABLE | {"rows": [["k"]]}, "has 1 cells, the header 2"),
        (TABLE | {"rows": [["k", "0.601"]]}, "must be a reference, not a number"),
        (TABLE | {"rows": []}, "note must state the reason"),
        (wang() | {"tables": []}, "tables must be Table 1 to 1"),
        (wang(rows=[*ROWS, ("", "=k9", "", "")]), "unknown value k9"),
        (wang(rows=[*ROWS, ROWS[0]]), "must be in one cell only, is in 2 cells"),
        (wang(rows=ROWS[:1]), "no cell for value k2-fea"),
        (wang(rows=[*ROWS, ("", "=b", "", "")]), "b, which is printed in Sec. 1.2"),
    ):
        with pytest.raises(ValidationError, match=message):
            (Paper if "tables" in raw else PrintedTable).model_validate(raw)


def test_the_theory_of_the_spring_constant_is_claimed_by_its_judged_rows(tables):
    cell = tables["wang2023", "Table 1"].rows[0][1]
    assert (cell.text, cell.value, cell.unit) == ("0.601", "wang2023:k1-theory", "N/mm")
    found = {row.row: row for row in cell.rows}
    own = found["spring-accordion/stiffness by Eqs. 1-9"]
    assert own.status is Status.PASS
    assert own.analytic == pytest.approx(0.601, abs=0.0005)  # half the last printed digit
    assert own.fem is None
    beam = found["spring-accordion/stiffness by Eqs. 1-9 against curved beam elements"]
    assert beam.fem == pytest.approx(0.601, rel=1e-3)
    assert beam.u is not None
    assert beam.u < 1e-6
    assert "eq-3-leaf-length" in cell.errata
