"""The cards on the page and in the PDF: text, combined limits, and figures."""

from dataclasses import replace

from reports.pdf_data import document
from reports.validity import figure, signed
from tests.reports.conftest import plain_text, section
from verify.core.results import (
    Validity,
    ValidityAxis,
    ValidityCard,
    ValidityExact,
    ValidityLimit,
    ValidityRegion,
)

Z = ValidityAxis(name="z", symbol="z", unit="1", values=(3.0, 6.0, 12.0), nominal=6.0)
D = ValidityAxis(name="d", symbol="δ_1", unit="mm", values=(2.0, 4.0), nominal=4.0)
FIVE = ValidityLimit(limit=0.05, inside=2, outside=3, undecided=0, words="z = 3, all δ_1",
                     box=(("z", 3.0, 3.0), ("d", 2.0, 4.0)))  # fmt: skip
TWO = replace(FIVE, limit=0.02, inside=1, undecided=1, words="z = 3, δ_1 = 2 mm",
              box=(("z", 3.0, 3.0), ("d", 2.0, 2.0)))  # fmt: skip
LIMITS = (TWO, FIVE, replace(FIVE, limit=0.10))
REGION = ValidityRegion(
    over="z 3 to 12 (3 values), δ_1 2 to 4 mm (2 values)", points=6, unsolved=1,
    problems=("1 point: refused: <b>too thin</b>",), limits=LIMITS,
    breaks="larger z: the error first exceeds 5 % between 3 and 6", axes=(Z, D),
    error=(0.01, 0.03, 0.3, 0.2, 0.15, float("nan")), U=(1e-3,) * 5 + (float("nan"),),
)  # fmt: skip
EVERYWHERE = replace(
    REGION, unsolved=0, problems=(), error=(0.01,) * 6, U=(1e-3,) * 6,
    limits=tuple(
        replace(one, inside=6, outside=0, undecided=0, words="the whole measured range", box=())
        for one in LIMITS
    ),
)  # fmt: skip
CARD = ValidityCard(
    case="polyhedral-ring", quantity="K of the paper", symbol="K", place="Belcin, Eq. 11",
    tex=r"K = \frac{a}{b}", error=-0.0123, U=0.0004, regions=(REGION, EVERYWHERE),
)  # fmt: skip
KNOWN = Validity(
    case="polyhedral-ring", title="Polyhedral ring", subject="Polyhedral rings", date="2026-11-22",
    cards=(CARD,), over="z 3 to 12 (3 values)", others=("hub at e",), maps=("polyhedral-ring",),
    exact=(ValidityExact(quantity="K in the mean", symbol="K", largest=-2.9e-6, U=1e-7, points=6,
                         unsolved=1),),
)  # fmt: skip
MISSING = Validity(
    case="polyhedral-ring", title="Polyhedral ring", subject="Polyhedral rings",
    missing="not measured for the present code: run `freewheel deep validity:polyhedral-ring`",
    others=("K of the paper",),
)  # fmt: skip


def test_a_card_stands_on_page_and_paper_and_what_is_not_measured_is_named(alone):
    one = replace(alone, validity=(KNOWN,))
    text = section(one, "validity")
    for words in (
        "K of the paper", "Belcin, Eq. 11; −1.2 ± 0.04 % at the inputs of the case",
        "1 of 6 points, 1 undecided", ">5, 10 %<", "Larger z: the error first exceeds 5",
        "2, 5, 10 %",
        "1 of 6 points without a solution</summary>1 point: refused: &lt;b&gt;too thin",
        "1 formula is exact within its model ", "−0.00029 ± 0.00001 %", "5 of 6",
        "Formulas without measurements at other inputs are: “hub at e”.",
        'href="#case-polyhedral-ring"',
    ):  # fmt: skip
        assert words in text
    assert text.count("the whole measured range") == 1  # one line for all three limits
    text = section(replace(one, validity=(MISSING,)), "validity")
    assert (
        "Not measured for the present code: run `freewheel deep validity:polyhedral-ring`." in text
    )
    assert "holds" not in text.replace("thresholds", "")
    assert "K of the paper" not in text
    over = REGION.over.replace("_", "")
    (subject,) = document(one, {})["validity"]
    (case,) = subject["cases"]
    first, second = ([plain_text(cell) for cell in row] for row in case["rows"])
    assert first == [
        f"K of the papermeasured over {over}", "−1.2 ± 0.04 %", "z = 3, δ1 = 2 mm", "z = 3, all δ1",
        "z = 3, all δ1", "larger z: the error first exceeds 5 % between 3 and 6; 1 of 6 "
                         "points without a solution",
    ]  # fmt: skip
    assert second[:2] == [f"measured over {over}", ""]
    assert "largest error is −0.00029 ± 0.00001 %" in plain_text(case["exact"])


def test_a_map_has_each_error_in_its_cell():
    """30 % is at z = 6 and δ_1 = 2 mm: the middle column, the lower row."""
    places = {}
    for piece in str(figure(REGION, "K")).split("<text")[1:]:
        attributes, _, words = piece.partition(">")
        if 'class="cell' in attributes:
            x, y = (float(attributes.split(f' {k}="')[1].split('"')[0]) for k in "xy")
            places[words.partition("<")[0]] = (x, y)
    assert places["1.0"][0] < places["30"][0] < places["15"][0]
    assert places["1.0"][1] == places["30"][1] > places["3.0"][1]
    assert places["1.0"][0] == places["3.0"][0]


def test_errors_in_per_cent():
    for error, U, words in (
        (None, None, "–"), (0.05, None, "+5 %"), (-0.0123, 0.0004, "−1.2 ± 0.04 %"),
        (0.254, 0.01, "+25 ± 1 %"), (2e-6, 1e-7, "+0.0002 ± 0.00001 %"),
        (-1.255e-4, 1.6e-4, "−0.013 ± 0.016 %"), (-0.003, 2e-14, "−0.3 ± <0.001 %"),
        (4e-14, 2e-12, "<0.000001 %"), (1e-10, 4e-8, "<0.000001 ± 0.000004 %"), (0.0, 0.0, "0 %"),
        (5e-10, None, "<0.000001 %"),
    ):  # fmt: skip
        assert signed(error, U) == words
