"""A repeated report: files without changes are not written again, all others are.

With it the drawing while cases are solved, and an interrupted run.
"""

import shutil
from dataclasses import replace
from types import SimpleNamespace

import pytest

from reports import ahead, slim
from reports import write as writing
from reports.ahead import Ahead
from reports.before import FILE
from reports.links import FIRST, FOLDER, path_of
from reports.origins import Origins, digests, part_of
from reports.write import PAPER, write
from tests.reports.conftest import first_of
from verify.jobs.cache import default_folder

pytestmark = pytest.mark.slow("a report is written several times")
ALWAYS = {FIRST, "results.json", "rows.csv", "cases.md", "junit.xml", "results.schema.json",
          "budget.csv", "crosscheck.csv", path_of("provenance")}  # fmt: skip
BOOK = "tables.xlsx"


@pytest.fixture(scope="module")
def some(report):
    """A few cases of the report, and little else."""
    return replace(first_of(report, 3), errata=())


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
    write(some, folder, cache=default_folder(), origins=origins)
    return folder


@pytest.fixture
def folder(first, tmp_path):
    """A copy of it that a test may change."""
    shutil.copytree(first, tmp_path, dirs_exist_ok=True)
    return tmp_path


def written(report, folder, origins):
    """The files that a run writes into a folder that has some."""
    before = {path: path.stat().st_ino for path in folder.rglob("*.*") if path.is_file()}
    write(report, folder, cache=default_folder(), origins=origins)
    return {
        path.relative_to(folder).as_posix() for path in folder.rglob("*.*")
        if path.is_file() and before.get(path) != path.stat().st_ino and path.name[0] != "."
    }  # fmt: skip


def test_what_has_not_changed_is_not_written_again_and_what_someone_changed_is(
    some, folder, origins
):
    pages = {path: path.read_bytes() for path in folder.glob(f"{FOLDER}/*.html")}
    assert written(some, folder, origins) <= ALWAYS
    edited, removed = (folder / path_of(case.id) for case in some.cases[:2])
    edited.write_text("", "utf-8")
    removed.unlink()
    found = written(some, folder, origins)  # unchanged parts are remembered
    assert found - ALWAYS == {path_of(case.id) for case in some.cases[:2]}
    assert {path: path.read_bytes() for path in folder.glob(f"{FOLDER}/*.html")} == pages


def test_of_a_changed_case_its_page_its_fields_tables_of_rows_and_the_pdf_are_written(
    some, folder, origins
):
    first, *others = some.cases
    fields = {path.name for path in folder.glob(f"{first.id}-*.vtu")}
    assert fields
    other, third = (
        replace(origins, cases={**origins.cases, first.id: key}) for key in ("other", "third")
    )
    assert written(some, folder, other) - ALWAYS == {path_of(first.id), PAPER, *fields}
    row = replace(first.rows[0], difference=0.123456 * first.rows[0].scale)
    changed = replace(some, cases=(replace(first, rows=(row, *first.rows[1:])), *others))
    found = written(changed, folder, third)
    assert {path_of(first.id), path_of("rows"), BOOK, PAPER} <= found
    assert not {path_of(case.id) for case in others} & found


@pytest.mark.parametrize("change", ["other code", "no origins", "torn note"])
def test_all_is_written_where_it_is_not_known_to_be_the_same(some, folder, origins, change):
    if change == "torn note":
        (folder / FILE).write_text("{", "utf-8")
    known = {"other code": replace(origins, code="other"), "no origins": None}.get(change, origins)
    found = written(some, folder, known)
    assert {path_of(case.id) for case in some.cases} | {PAPER, BOOK} <= found


def test_a_run_of_other_cases_or_in_one_file_removes_pages_of_the_one_before(some, folder, origins):
    write(replace(some, cases=some.cases[:2]), folder, cache=default_folder(), origins=origins)
    last = folder / path_of(some.cases[2].id)
    assert not last.exists()
    assert path_of(some.cases[2].id) in written(some, folder, origins)
    write(some, folder, cache=default_folder(), origins=origins, single_file=True)
    assert not [*folder.glob(f"{FOLDER}/*.html")]
    page = (folder / FIRST).read_text("utf-8")
    assert all(f"id=case-{case.id}>" in page for case in some.cases)


def test_a_page_over_the_limit_is_reported(some, tmp_path, monkeypatch):
    monkeypatch.setattr(slim, "MOST", 50_000)
    remarks = write(some, tmp_path, cache=default_folder()).remarks
    large = {path.name for path in tmp_path.rglob("*.html") if path.stat().st_size > 50_000}
    assert len(large) == len(remarks) > 1
    assert all(any(one.partition(" ")[0].endswith(name) for one in remarks) for name in large)


def test_a_case_without_a_key_has_all_parts_written(some, origins):
    known = dict(origins.cases)
    known.pop(some.cases[0].id)
    assert digests(some, replace(origins, cases=known), "") == digests(some, None, "") == {}
    parts = digests(some, origins, "")
    assert {part_of(path_of(case.id)) for case in some.cases} <= set(parts)
    assert part_of(path_of("rows")) in parts
    assert part_of(FIRST) not in parts


@pytest.fixture
def drawn_ahead(monkeypatch):
    """The cases that were drawn, each with the process; the first fails."""
    found = []

    def frames(cases, _folder, _hint, process):
        found.append(([one.id for one in cases], process))
        if len(found) == 1:
            raise OSError("no room")

    monkeypatch.setattr(ahead, "frames", frames)
    return found


def test_each_case_is_drawn_as_it_comes_by_one_process(drawn_ahead, tmp_path):
    done = []

    def first():
        done.append("read")
        raise ValueError("of other work")

    with Ahead(tmp_path, "", first) as pictures:
        for n in range(3):
            pictures.add(SimpleNamespace(id=f"case {n}", figures=()))
    assert done == ["read"]
    assert [names for names, _ in drawn_ahead] == [["case 0"], ["case 1"], ["case 2"]]
    assert len({id(process) for _, process in drawn_ahead}) == 1


def test_an_interrupted_run_does_not_wait_for_drawings(drawn_ahead, tmp_path):
    waiting = SimpleNamespace(is_over=False)

    def first():
        while not waiting.is_over:
            pass

    with pytest.raises(KeyboardInterrupt), Ahead(tmp_path, "", first):
        raise KeyboardInterrupt
    waiting.is_over = True
    assert drawn_ahead == []
