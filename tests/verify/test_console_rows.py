"""Rows on the terminal: what the columns hold, and what the closing sentences name."""

from dataclasses import replace

from verify.core.console import raised
from verify.core.console_rows import closing, row_cells, title
from verify.core.references import reference_name
from verify.core.results import Kind, Partner
from verify.judging import judge
from verify.judging.claims import make_row


def row(name, formula, interval=(0.0, 0.02), case="ring-lame", by=""):
    verdict = judge.approximation(formula, 1.0, U=1e-4, interval=interval, demand=0.1)
    other = {"partner": Partner(by=by, value=1.0)} if by else {"fem": 1.0}
    return make_row(
        case, Kind.APPROXIMATION, verdict, name, "x", "1", analytic=formula, scale=1.0,
        interval=interval, **other,
    )  # fmt: skip


ROWS = [row("judged", 1.01), row("printed form", 0.7, None)]  # 30 % off and not judged


def test_the_closing_sentences_name_the_largest_of_all_rows():
    passed, apart, limit, unjudged = closing(ROWS)
    assert passed == "1 of 2 comparisons pass"
    assert apart == (
        "largest difference of all comparisons: -30 % (printed form; reference: finite "
        "elements; SHOWN, not judged)"
    )
    assert limit == "detection limit of the judged rows: 0.98 %"
    assert unjudged == "not judged: 1 SHOWN (printed form: -30 %)"
    # of many that are not judged the largest are named
    many = [row(f"row {i}", 1 + 0.01 * i, None) for i in range(1, 9)]
    (*_, last) = closing([ROWS[0], *many])
    assert last.startswith("not judged: 8 SHOWN (row 8: +8.0 %; row 7: +7.0 %; ")
    assert last.endswith("; row 4: +4.0 %; and 3 more)")
    # rows that failed count for the largest
    words = "+100 % (broken; reference: finite elements; expected 0 % to +2.0 %)"
    assert words in closing([*ROWS, row("broken", 2.0)])[1]


def test_a_column_headed_fe_holds_finite_elements_only():
    assert row_cells(ROWS)[0][3] == "FE"
    head, _, _, strips = row_cells([*ROWS, row("by strips", 1.01, by="strips")])
    assert "FE" not in head
    assert head[3:5] == ("reference", "by")
    assert strips[4] == "strips"
    # a case without finite elements names its method
    one = replace(row("balance", 1.01, case="contact-roller"), method="half-space")
    head, line = row_cells([one])
    assert "FE" not in (*head, *line)
    assert title([one]) == "formulas against half-space"
    assert reference_name(replace(one, quantity="pressure, plane finite elements")) == "FE"


def test_finite_elements_come_first_and_printed_numbers_last_in_the_title():
    others = [row(by, 1.01, by=by) for by in ("printed 0.6", "printed 0.7", "strips")]
    assert title([*others, *ROWS]) == "formulas against finite elements; strips; printed values"


def test_powers_are_raised_in_the_terminal():
    assert raised("1.97×10^-4 kg m^2") == "1.97×10⁻⁴ kg m²"
    assert raised("x^n plain") == "x^n plain"
