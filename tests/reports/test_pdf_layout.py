"""Where things stand on the pages of report.pdf: nothing squeezed, nothing beyond the margins."""

import re
import shutil
import subprocess
from dataclasses import replace
from typing import NamedTuple

import pytest

from reports.pdf import pdf
from verify.cases.registry import CASES
from verify.commands import make_report
from verify.results import Partner, Published, Status

pytestmark = pytest.mark.skipif(not shutil.which("pdftotext"), reason="needs poppler-utils")

MM = 72 / 25.4
RIGHT = (210 - 17) * MM  # edge of the text
NAME = " ".join(["word"] * 18)  # 90 letters
BY = "Runge-Kutta steps, compiled and checked"
PRINTED = Published(document="d", id="i", place="p", kind="theory", printed="1.97×10^-4",
                    value=1.97e-4, unit="kg m^2")  # fmt: skip


class Word(NamedTuple):
    """A printed word: left, top, right, bottom [pt], and its letters."""

    left: float
    top: float
    right: float
    bottom: float
    text: str


@pytest.fixture(scope="module")
def case(judged):
    """A case with long names, another method's values and the longest words for a status."""
    result = judged(CASES[0])
    row = next(row for row in result.rows if row.grid is not None)
    other = replace(row, fem=None, partner=Partner(by=BY, value=row.fem))
    rows = tuple(
        replace(other, quantity=f"{NAME} {status}", status=status, published=(PRINTED,))
        for status in Status
    )
    return replace(result, rows=rows, name="mine", figures=(), tables=())


def words(report, folder) -> list[Word]:
    """All words of the PDF."""
    (folder / "r.pdf").write_bytes(pdf(report, {}))
    run = ["pdftotext", "-bbox", str(folder / "r.pdf"), "-"]
    found = re.findall(
        r'xMin="([\d.]+)" yMin="([\d.]+)" xMax="([\d.]+)" yMax="([\d.]+)">([^<]*)<',
        subprocess.run(run, capture_output=True, text=True, check=True).stdout,
    )
    return [Word(*map(float, numbers), text) for *numbers, text in found]


@pytest.fixture(scope="module")
def printed(case, tmp_path_factory):
    report = replace(make_report([case], CASES[:1], 1.0), name="mine")
    return words(report, tmp_path_factory.mktemp("pdf"))


def test_names_of_quantities_have_four_centimetres(printed):
    texts = [w.text for w in printed]
    summary = printed[texts.index("Quantity") : texts.index("budget:")]
    at = [w for w in summary if w.text == "word"]
    assert len(at) >= 18 * 3
    assert max(w.right for w in at) - min(w.left for w in at) > 35 * MM  # a word is 5 mm wide


def test_no_word_stands_beyond_the_margin(printed):
    assert "CALIBRATED" in {w.text for w in printed}
    assert max(w.right for w in printed) <= RIGHT + 0.5


def test_printed_powers_are_raised(printed):
    assert not any("^" in w.text for w in printed)
