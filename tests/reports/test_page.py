"""The page and its subpages as text: self-contained, escaped, complete, with valid links."""

import base64
import hashlib
import re
from dataclasses import replace
from html.parser import HTMLParser

import pytest

from reports.first_page import groups, paper_parts, stated, tasks
from reports.formats import values
from reports.html import anchors, page
from reports.links import FIRST, FOLDER
from reports.pages import SECTIONS, is_paged
from reports.pages import pages as as_pages
from reports.row_lines import lines
from reports.slim import unquoted
from verify.cases.registry import CASES
from verify.core.results import Kind, Status
from verify.core.verdicts import Verdict
from verify.verdicts.record import kept

pytestmark = pytest.mark.slow("the cases of a report are judged first")

VOID = {"meta", "link", "br", "wbr", "img", "input", "hr"}
OPTIONAL = {"tr", "td", "th"}  # their ends may be left out
SVG_EMPTY = {"path", "circle", "rect", "line", "use", "image", "stop"}  # close themselves


class Reader(HTMLParser):
    """Checks that tags close; collects scripts, foreign addresses, ids and links within."""

    def __init__(self):
        super().__init__()
        self.open, self.scripts, self.foreign, self.handlers = [], [], [], []
        self.ids, self.links, self._script, self.policy = [], [], None, ""

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        if tag == "script":
            self._script = values.get("type", "")
            self.scripts.append([self._script, ""])
        ended = {"tr": OPTIONAL, "td": OPTIONAL - {"tr"}, "th": OPTIONAL - {"tr"}}.get(tag, ())
        while ended and self.open[-1] in ended:
            self.open.pop()
        if tag not in VOID | SVG_EMPTY:
            self.open.append(tag)
        if values.get("http-equiv") == "Content-Security-Policy":
            self.policy = values["content"]
        self.ids += [values["id"]] if "id" in values else []
        self.links += [values["href"]] if tag in ("a", "use") else []
        self.handlers += [k for k in values if k.startswith("on")]
        self.foreign += [
            (k, v) for k, v in attrs
            if k in ("href", "src", "action", "xlink:href", "style") and v
            and re.match(r"(https?:|//|file:|javascript:|.*url\((?!#))", v)
        ]  # fmt: skip

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID | SVG_EMPTY:
            self.open.pop()

    def handle_data(self, data):
        if self._script is not None:
            self.scripts[-1][1] += data

    def handle_endtag(self, tag):
        if tag == "script":
            self._script = None
        while self.open[-1] in OPTIONAL and self.open[-1] != tag:
            self.open.pop()
        if tag not in VOID | SVG_EMPTY:
            assert self.open.pop() == tag


def read(html: str) -> Reader:
    """A page that is well-formed and self-contained, and whose scripts its policy names."""
    reader = Reader()
    reader.feed(html)
    assert reader.open == reader.foreign == reader.handlers == []
    assert len(set(reader.ids)) == len(reader.ids)
    assert "default-src 'none'" in reader.policy
    for code in (code for kind, code in reader.scripts if kind != "application/json"):
        digest = base64.b64encode(hashlib.sha256(code.encode()).digest()).decode()
        assert f"script-src 'sha256-{digest}'" in reader.policy
    return reader


@pytest.fixture(scope="module")
def hostile_text(hostile, drawn) -> str:
    return page(hostile, drawn)


def test_the_one_page_is_whole_and_its_links_lead_within_it(text, hostile_text):
    for html in (text, hostile_text):
        reader = read(html)
        assert sum(kind != "application/json" for kind, _ in reader.scripts) == 1
        assert set(reader.links) <= {f"#{place}" for place in reader.ids}


def test_each_of_several_pages_is_whole_and_its_links_lead_to_places(made, report):
    names = {name.removeprefix(f"{FOLDER}/").removesuffix(".html") for name in made}
    assert {case.id for case in report.cases} <= names
    assert names - {case.id for case in report.cases} <= {*SECTIONS, "report"}
    readers = {name: read(unquoted(html)) for name, html in made.items()}
    for name, reader in readers.items():
        for link in (one for one in reader.links if not one.startswith("data:")):
            path, _, place = link.partition("#")
            folder = "" if name == FIRST else f"{FOLDER}/"
            target = (folder + path).replace(f"{FOLDER}/../", "") if path else name
            assert target in readers, (name, link)
            assert not place or place in readers[target].ids, (name, link)


def test_what_a_user_typed_is_never_markup(hostile, drawn, hostile_text):
    named = replace(hostile, name="<script>alert(1)</script>")
    cases = tuple(replace(c, name="<img src=x onerror=alert(1)>") for c in hostile.cases)
    shown = page(replace(named, cases=cases), drawn)
    for html in (hostile_text, shown):
        assert "<script>alert" not in html
        assert "<img" not in html
        assert "<b>_x" not in html
    assert "&lt;script&gt;alert(1)" in shown
    for status in Status:
        assert f'class="state is-{status.value.lower()}">{status.value}<' in hostile_text
        assert f'id="show-{status.value.lower()}"' in hostile_text
    data = as_pages(hostile, {})[f"{FOLDER}/explorer.html"].partition('id="explorer-data">')[2]
    assert "<" not in data.partition("</script>")[0]


def test_what_was_judged_can_be_read_off_the_page(report, text):
    """Formula and FE as printed differ by the printed difference, to the last printed digit."""
    assert not re.search(r">[^<]*\b(None|nan|inf)\b[^<]*<", text)
    for line in lines(report.rows):
        row = line.row
        if row.kind is not Kind.IDENTITY or row.fem is None or not row.u_num:
            continue
        shown = values(row)
        assert f">{shown.formula}</td>" in text
        assert re.search(f">{re.escape(str(shown.fem))}(?:</td>|<small)", text)
        fem, _, u = str(shown.fem).replace("−", "-").partition("(")
        decimals = len(fem.partition(".")[2])
        last = 10.0**-decimals  # u keeps two digits, where nine of the value have room for them
        assert abs(float(fem) - row.fem) <= max(row.u_num / 5, 0.51 * last)
        printed_value = float(u.rstrip(")")) * last
        assert abs(printed_value - max(row.u_num, last)) <= max(0.06 * row.u_num, 0.51 * last)


def test_the_first_page_has_each_verdict_once_and_equal_formulas_in_one_line(made):
    shown = [v for v in kept() if v.verdict is not Verdict.DEFINITION]
    assert made[FIRST].count('id="verdict-') == len(shown)
    found = groups([v for v in kept() if v.paper == "wang2023"])
    assert "Eqs. 1, 2, 3, 4, 5, 6" in [one.name for one in found]  # corrected
    assert sum(len(one.formulas) for one in found) == sum(v.paper == "wang2023" for v in shown)


def test_claims_and_tasks_are_of_papers_formulas_and_cases_that_exist(report):
    known = {v.id for v in kept()}
    assert {one["key"] for one in stated()["papers"]} == {v.paper for v in kept()}
    for task in stated()["tasks"]:
        assert set(task["formulas"]) <= known
        init = re.match(r"freewheel init ([a-z-]+)", task["tool"])
        assert init[1] in {*CASES.ids, "design-spring", "design-sprag"}
    assert sum(map(len, tasks(report).values())) == len(stated()["tasks"])
    parts = paper_parts(report)
    assert [c.id for part in parts for c in part.cases if c.paper != part.key] == []


def test_passed_rows_without_further_content_are_in_the_appendix(made, report):
    case = next(c for c in report.cases if c.id == "freewheel-torque")
    page = made[f"{FOLDER}/{case.id}.html"]
    main, _, rest = page.partition('id="more-rows"')
    settled = [r for r in case.rows if r.kind is Kind.EXACT and r.status is Status.PASS]
    assert settled
    for row in settled:
        place = anchors(report.rows)[row.id]
        assert f'id="{place}"' in rest
        assert f'id="{place}"' not in main


def test_a_run_of_a_user_s_part_or_of_one_case_is_one_page(report):
    assert is_paged(report)
    assert not is_paged(replace(report, name="mine"))
    assert not is_paged(replace(report, cases=report.cases[:1]))
