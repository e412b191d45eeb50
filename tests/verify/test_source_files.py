"""Digests of files of the project: files that a module depends on, and detection of changes."""

import pytest

from verify.cases.registry import CASES
from verify.core import module_syntax, source_code, source_files

FILES = {
    "fem/__init__.py": "",
    "fem/plane/__init__.py": "",
    "fem/plane/solve.py": "from fem.plane import (  # both (of them)\n    parts,\n    rule as r)\n",
    "fem/plane/parts.py": "def f():\n    import fem.late\n",
    "fem/plane/rule.py": "from fem.open import solved\nimport fem.wide\n",
    "fem/plane/data.toml": "",
    "fem/late.py": "from fem \\\n    import last\n",
    "fem/last.py": "",
    "fem/open/__init__.py": "",
    "fem/open/__init__.pyi": "from fem.open.used import inner as solved\n"
    "from fem.open.unused import other\n",
    "fem/open/used.py": "",
    "fem/open/unused.py": "",
    "fem/wide/__init__.py": "",
    "fem/wide/__init__.pyi": "from fem.wide.part import anything\n",
    "fem/wide/part.py": "",
    "fem/single.py": "",
    "fem/tables/numbers.csv": "",
    "verify/jobs/records.py": "",
    "verify/measured/kind/case.json": "",
    "verify/reader.py": "import verify.jobs.records",
    "fem/__pycache__/solve.pyc": "",
    "reports/out/report.html": "",
}
APART = {
    "fem/single.py",
    "fem/open/unused.py",  # a public name of a package that nobody imports
    "verify/jobs/records.py",
    "verify/measured/kind/case.json",
    "verify/reader.py",
}
NEVER = {"fem/__pycache__/solve.pyc", "reports/out/report.html"}


@pytest.fixture
def root(tmp_path, monkeypatch):
    """A small project."""
    monkeypatch.setattr(source_files, "ROOT", tmp_path)
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    source_files.forget()
    yield tmp_path
    source_files.forget()


def seen(root, name, digest):
    """Whether a change of a file changes a digest."""
    source_files.forget()
    before = digest()
    with (root / name).open("a") as file:
        file.write("# more\n")
    source_files.forget()
    return digest() != before


def test_a_module_depends_on_what_it_imports_anywhere_and_on_data_beside(root):
    for name in FILES:
        of_module = seen(root, name, lambda: source_files.digest_of("fem.plane.solve"))
        assert of_module == (name not in APART | NEVER), name
    # records count for what reads records
    name = "verify/measured/kind/case.json"
    assert seen(root, name, lambda: source_files.digest_of("verify.reader"))


def test_comments_and_layout_count_for_no_code_but_for_data(root):
    before = source_files.code_of("fem.plane.solve")
    for name, text, is_seen in (
        ("fem/last.py", "# more\n\n", False), ("fem/last.py", "a = 1\n", True),
        ("fem/plane/data.toml", "# more\n", True),
    ):  # fmt: skip
        (root / name).write_text(text)
        source_files.forget()
        assert (source_files.code_of("fem.plane.solve") != before) == is_seen
        before = source_files.code_of("fem.plane.solve")


def test_the_digest_of_all_follows_every_file_but_what_a_run_writes(root):
    for name in FILES:
        assert seen(root, name, source_files.digest) == (name not in NEVER), name
    found = [source_files.digest()]
    (root / "fem/single.py").rename(root / "fem/away.py")
    source_files.forget()
    found.append(source_files.digest())
    (root / "fem/new.toml").write_text("")
    source_files.forget()
    found.append(source_files.digest())
    assert len(set(found)) == 3


@pytest.mark.parametrize("case_id", CASES.ids)
def test_no_module_is_missed_that_a_reference_or_a_formula_reaches(case_id):
    """Import statements found in the text are those of the syntax trees."""
    case, files = CASES.named(case_id), source_files._files_of(CASES.module_of(case_id))
    reached = {
        *source_code.modules_of(case.reference),
        *source_code.whole_parts_of(case.analytic)[1],
    }
    assert reached
    for module in reached:
        path = module_syntax.file_of(module).relative_to(source_files.ROOT).as_posix()
        assert path in files, module
