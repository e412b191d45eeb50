"""The page as text: self-contained, escaped, whole."""

import base64
import hashlib
import re
from dataclasses import replace
from html.parser import HTMLParser

import pytest

from reports.formats import values
from reports.frames import frames
from reports.html import page
from reports.row_lines import lines
from verify.core.results import Kind, Status
from verify.jobs.cache import default_folder

VOID = {"meta", "link", "br", "img", "input", "hr"}
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
        if tag not in VOID | SVG_EMPTY:
            self.open.append(tag)
        if values.get("http-equiv") == "Content-Security-Policy":
            self.policy = values["content"]
        self.ids += [values["id"]] if "id" in values else []
        self.links += [values["href"]] if tag == "a" else []
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
        if tag not in VOID | SVG_EMPTY:
            assert self.open.pop() == tag


@pytest.fixture(scope="module")
def drawn(report):
    return frames(report.cases, default_folder())


@pytest.fixture(scope="module")
def text(report, drawn) -> str:
    return page(report, drawn)


@pytest.fixture(scope="module")
def hostile_text(hostile, drawn) -> str:
    return page(hostile, drawn)


@pytest.mark.parametrize("which", ["text", "hostile_text"])
def test_the_page_is_well_formed_self_contained_and_its_one_script_is_named(which, request):
    reader = Reader()
    reader.feed(request.getfixturevalue(which))
    assert reader.open == reader.foreign == reader.handlers == []
    assert len(set(reader.ids)) == len(reader.ids)
    assert all(link.startswith("#") for link in reader.links)
    assert {link[1:] for link in reader.links} <= set(reader.ids)
    (own,) = [code for kind, code in reader.scripts if kind != "application/json"]
    digest = base64.b64encode(hashlib.sha256(own.encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}'" in reader.policy
    assert "default-src 'none'" in reader.policy


def test_what_a_user_typed_is_never_markup(hostile, drawn, hostile_text):
    named = replace(hostile, name="<script>alert(1)</script>")
    cases = tuple(replace(c, name="<img src=x onerror=alert(1)>") for c in hostile.cases)
    for shown in (hostile_text, page(replace(named, cases=cases), drawn)):
        assert "<script>alert" not in shown
        assert "<img" not in shown
        assert "<b>_x" not in shown
    assert "&lt;script&gt;alert(1)" in page(named, drawn)


def test_every_status_is_on_the_page(hostile_text):
    for status in Status:
        assert f'class="state is-{status.value.lower()}">{status.value}<' in hostile_text
        assert f'id="show-{status.value.lower()}"' in hostile_text


def test_what_was_judged_can_be_read_off_the_page(report, text):
    """Formula and FE as printed differ by the printed difference, to the last digit shown."""
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
        told = float(u.rstrip(")")) * last
        assert abs(told - max(row.u_num, last)) <= max(0.06 * row.u_num, 0.51 * last)
