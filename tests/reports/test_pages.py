"""The report as pages: links between them, their size, the first one and those of cases."""

import re
from dataclasses import replace

import pytest

from reports.first_page import groups, paper_parts, stated, tasks
from reports.html import anchors
from reports.links import FIRST, FOLDER, Places, linked
from reports.pages import SECTIONS, is_paged, pages
from reports.row_lines import lines
from reports.write import write
from tests.reports.browser import DARK, NO_CHROMIUM, assert_silent, looked_at
from verify.cases.registry import CASES
from verify.core.results import Kind, Status
from verify.core.verdicts import Verdict
from verify.verdicts.record import kept

MOST = 400_000  # bytes of a page
IDS = re.compile(r'\bid="([^"]+)"')
LINKS = re.compile(r'href="([^"]+)"')


@pytest.fixture(scope="module")
def made(report):
    return pages(replace(report, verdicts=kept()), {})


def test_there_is_a_first_page_one_for_each_case_and_those_of_records(made, report):
    names = {name.removeprefix(f"{FOLDER}/").removesuffix(".html") for name in made}
    assert {case.id for case in report.cases} <= names
    assert names - {case.id for case in report.cases} <= {*SECTIONS, "report"}


def test_each_link_leads_to_a_place_on_a_page(made):
    places = {name: set(IDS.findall(page)) for name, page in made.items()}
    for name, page in made.items():
        for link in LINKS.findall(page):
            path, _, place = link.partition("#")
            if link.startswith("data:"):
                continue
            folder = "" if name == FIRST else f"{FOLDER}/"
            target = (folder + path).replace(f"{FOLDER}/../", "") if path else name
            assert target in places, (name, link)
            assert not place or place in places[target], (name, link)


def test_a_page_has_each_place_once_and_needs_no_network(made):
    for page in made.values():
        found = IDS.findall(page)
        assert len(found) == len(set(found))
        assert not re.search(r"""(src|href)=["']https?:""", page)
        assert "default-src 'none'" in page


def test_pages_stay_small(made):
    sizes = {name: len(page.encode()) for name, page in made.items()}
    assert {name: size for name, size in sizes.items() if size > MOST} == {}


def test_links_to_rows_lead_to_the_page_of_their_case(report):
    places, case = Places(report), report.cases[1].id
    assert report.rows[0].case == report.cases[0].id
    found = linked(FIRST, '<a href="#row-1-7">x</a>', places)
    assert found == f'<a href="{FOLDER}/{case}.html#row-1-7">x</a>'
    here = '<i id="row-1-7"></i><a href="#row-1-7">x</a>'
    assert linked(f"{FOLDER}/{case}.html", here, places) == here


def test_links_back_go_up_one_folder(report):
    found = linked(f"{FOLDER}/x.html", '<a href="#design"></a>#a', Places(report))
    assert found == '<a href="../report.html#design"></a>#a'


def test_the_first_page_shows_each_verdict_once(made):
    shown = [v for v in kept() if v.verdict is not Verdict.DEFINITION]
    assert made[FIRST].count('id="verdict-') == len(shown)


def test_alike_formulas_stand_in_one_line():
    found = groups([v for v in kept() if v.paper == "wang2023"])
    names = [one.name for one in found]
    assert "Eqs. 1, 2, 3, 4, 5, 6" in names  # corrected
    assert sum(len(one.formulas) for one in found) == sum(
        v.paper == "wang2023" and v.verdict is not Verdict.DEFINITION for v in kept()
    )


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


def test_rows_that_hold_and_say_no_more_stand_in_the_appendix(made, report):
    case = next(c for c in report.cases if c.id == "freewheel-torque")
    page = made[f"{FOLDER}/{case.id}.html"]
    main, _, rest = page.partition('id="more-rows"')
    settled = [r for r in case.rows if r.kind is Kind.EXACT and r.status is Status.PASS]
    assert settled
    for row in settled:
        place = anchors(report.rows)[row.id]
        assert f'id="{place}"' in rest
        assert f'id="{place}"' not in main


def test_a_run_of_one_s_own_part_or_of_one_case_is_one_page(report):
    assert is_paged(report)
    assert not is_paged(replace(report, name="mine"))
    assert not is_paged(replace(report, cases=report.cases[:1]))


def test_pages_of_a_run_before_go(report, tmp_path):
    old = tmp_path / FOLDER / "gone.html"
    old.parent.mkdir()
    old.write_text("", "utf-8")
    write(report, tmp_path)
    assert not old.exists()
    assert {p.stem for p in old.parent.glob("*.html")} >= {case.id for case in report.cases}


def test_one_file_for_mail_has_all_cases(report, tmp_path):
    write(report, tmp_path, single_file=True)
    page = (tmp_path / FIRST).read_text("utf-8")
    assert all(f'id="case-{case.id}"' in page for case in report.cases)
    assert not (tmp_path / FOLDER).exists()


@pytest.fixture(scope="module")
def folder(made, tmp_path_factory):
    """The pages as files."""
    place = tmp_path_factory.mktemp("pages")
    for name, page in made.items():
        (place / name).parent.mkdir(exist_ok=True)
        (place / name).write_text(page, "utf-8")
    return place


@NO_CHROMIUM
@pytest.mark.slow("a browser opens pages at two widths and in dark colours")
@pytest.mark.parametrize(
    ("name", "width", "flags"),
    [
        (FIRST, 390, ()), (FIRST, 1320, (DARK,)), (f"{FOLDER}/spring-accordion.html", 390, ()),
        (f"{FOLDER}/rows.html", 390, ()), (f"{FOLDER}/papers.html", 1320, ()),
    ],
)  # fmt: skip
def test_pages_are_silent_and_legible_at_every_width(folder, name, width, flags):
    path = folder / name
    seen = looked_at(path.parent, path.stem, width, *flags)
    assert_silent(seen)
    assert bool(seen["dark"]) == bool(flags)
    assert seen["contrast"] >= 4.5, seen["faintest"]
    assert seen["covered"] == 0


@NO_CHROMIUM
@pytest.mark.slow("a browser types into the search")
def test_the_search_shows_rows_with_all_words(folder):
    seen = looked_at(folder / FOLDER, "rows", 1320, host="search_host.html", status="peak star")
    assert len(seen["all"]["rows"]) > 200
    assert seen["all"]["said"] == ""
    assert seen["none"] == {"rows": [], "said": "0 rows"}
    found = seen["some"]["rows"]
    assert seen["some"]["said"] == f"{len(found)} row{'s' if len(found) > 1 else ''}"
    assert 0 < len(found) < len(seen["all"]["rows"])


@NO_CHROMIUM
@pytest.mark.slow("a browser types into the search")
def test_the_search_finds_symbols_and_leaves_out_a_status(folder, report):
    seen = looked_at(folder / FOLDER, "rows", 1320, host="search_host.html", status="peak star")
    alone = [line.row for case in report.cases for line in lines(case.rows)]
    quantities = {
        "mu": [r.quantity for r in alone if r.symbol.startswith("μ")],
        "indexed": [r.quantity for r in alone if r.symbol.replace("_", "").lower()[:2] == "ur"],
        "capital": [r.quantity for r in alone if r.symbol.startswith("U")],
        "failed": [r.quantity for r in alone if r.status is not Status.PASS],
    }
    for name, expected in quantities.items():
        assert expected
        assert sorted(seen[name]["rows"]) == sorted(expected), name
