"""A report that is written again: files of which nothing has changed stay, all others are made."""

import shutil
from dataclasses import replace

import pytest

from reports import write as writing
from reports.before import FILE
from reports.links import FIRST, path_of
from reports.origins import Origins, digests, part_of
from reports.write import PAPER, write

pytestmark = pytest.mark.slow("a report is written several times")
ALWAYS = {FIRST, "results.json", "rows.csv", "cases.md", "junit.xml", "results.schema.json",
          "budget.csv", "crosscheck.csv", path_of("provenance")}  # fmt: skip


@pytest.fixture(scope="module")
def some(report):
    """A few cases of the report."""
    return replace(report, cases=report.cases[:3], tables=(), errata=(), searches=())


@pytest.fixture(scope="module")
def origins(some):
    return Origins("code", {case.id: f"key of {case.id}" for case in some.cases})


@pytest.fixture(scope="module", autouse=True)
def _without_pdf():
    """Its making takes most of the time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(writing, "content", lambda *_: "")
        patch.setattr(writing, "printed", lambda *_: b"%PDF")
        yield


@pytest.fixture(scope="module")
def first(some, origins, tmp_path_factory):
    """A folder with the report."""
    folder = tmp_path_factory.mktemp("first")
    write(some, folder, origins=origins)
    return folder


@pytest.fixture
def folder(first, tmp_path):
    """A copy of it that a test may change."""
    shutil.copytree(first, tmp_path, dirs_exist_ok=True)
    return tmp_path


def written(report, folder, origins):
    """The files that a run writes into a folder that has some."""
    before = {path: path.stat().st_ino for path in folder.rglob("*.*") if path.is_file()}
    write(report, folder, origins=origins)
    return {
        path.relative_to(folder).as_posix() for path in folder.rglob("*.*")
        if path.is_file() and before.get(path) != path.stat().st_ino and path.name[0] != "."
    }  # fmt: skip


def test_what_has_not_changed_is_not_written_again(some, folder, origins):
    pages = {path.name: path.read_bytes() for path in folder.glob("report/*.html")}
    assert written(some, folder, origins) <= ALWAYS
    assert written(some, folder, origins) <= ALWAYS  # kept parts are remembered
    made = {path.name: path.read_bytes() for path in folder.glob("report/*.html")}
    assert made == pages


def test_of_a_changed_case_its_page_its_fields_and_the_pdf_are_written(some, folder, origins):
    case = some.cases[0]
    other = replace(origins, cases={**origins.cases, case.id: "another"})
    fields = {f"{path.name}" for path in folder.glob(f"{case.id}-*.vtu")}
    assert fields
    assert written(some, folder, other) - ALWAYS == {path_of(case.id), PAPER, *fields}


def test_a_changed_row_is_written_to_the_tables_of_rows_and_to_the_workbook(some, folder, origins):
    first, *others = some.cases
    row = replace(first.rows[0], difference=0.123456 * first.rows[0].scale)
    changed = replace(some, cases=(replace(first, rows=(row, *first.rows[1:])), *others))
    other = replace(origins, cases={**origins.cases, first.id: "another"})
    found = written(changed, folder, other)
    assert {path_of(first.id), path_of("rows"), "tables.xlsx", PAPER} <= found
    assert not {path_of(case.id) for case in others} & found


def test_other_code_writes_all(some, folder, origins):
    found = written(some, folder, replace(origins, code="other"))
    assert {path_of(case.id) for case in some.cases} | {PAPER, "tables.xlsx"} <= found


def test_without_origins_all_is_written(some, folder):
    found = written(some, folder, None)
    assert {path_of(case.id) for case in some.cases} | {PAPER, "tables.xlsx"} <= found


@pytest.mark.parametrize("change", ["edited", "removed", "torn note"])
def test_a_file_that_someone_changed_is_written_again(some, folder, origins, change):
    page = folder / path_of(some.cases[1].id)
    text = page.read_bytes()
    if change == "edited":
        page.write_text("", "utf-8")
    elif change == "removed":
        page.unlink()
    else:
        (folder / FILE).write_text("{", "utf-8")
    assert path_of(some.cases[1].id) in written(some, folder, origins)
    assert page.read_bytes() == text


def test_a_run_of_other_cases_removes_the_pages_of_the_first(some, folder, origins):
    write(replace(some, cases=some.cases[:2]), folder, origins=origins)
    last = path_of(some.cases[2].id)
    assert not (folder / last).exists()
    assert last in written(some, folder, origins)


def test_a_case_without_a_key_has_all_parts_written(some, origins):
    known = dict(origins.cases)
    known.pop(some.cases[0].id)
    assert digests(some, replace(origins, cases=known), "") == digests(some, None, "") == {}
    parts = digests(some, origins, "")
    assert {part_of(path_of(case.id)) for case in some.cases} <= set(parts)
    assert part_of(path_of("rows")) in parts
    assert part_of(FIRST) not in parts
