"""The walls of the house: who may import whom."""

import ast
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

from verify.cases.registry import CASES

ROOT = Path(__file__).parents[2]


def test_import_contracts_are_kept():
    done = subprocess.run(
        [Path(sys.executable).parent / "lint-imports", "--no-cache"],
        capture_output=True, text=True, check=False, cwd=ROOT, timeout=120,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("package", ["analytic", "fem"])
def test_formulas_and_finite_elements_import_nothing_of_each_other(package):
    """Also inside functions, where an import contract might be argued with."""
    other = {"analytic": "fem", "fem": "analytic"}[package]
    for path in (ROOT / package).rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            names = [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            names += [a.name for a in node.names] if isinstance(node, ast.Import) else []
            tops = {name.partition(".")[0] for name in names}
            assert not tops & {other, "meshes", "verify", "reports"}, path


# a half-space, and what it and finite elements take of formulas: crowns, a load
REFERENCE = {"reference", "pressed", "gap", "even_crowns", "plane_at_middle", "best", "grip"}


def test_only_what_makes_the_reference_or_is_compiled_imports_below_the_top_of_a_file():
    """Finite elements or a half-space, on which results depend, and what `dynamic` runs."""
    for path in (ROOT / "verify" / "cases").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.FunctionDef) and not (
                "fem" in node.name
                or "dynamic" in node.name
                or node.name in REFERENCE
                or path.stem in ("reference", "fem")
            ):
                inner = [n for n in ast.walk(node) if isinstance(n, ast.Import | ast.ImportFrom)]
                assert not inner, f"{path.name}: {node.name}"


def test_fem_knows_no_subject():
    subjects = ("ring", "spring", "accordion", "sprag", "freewheel", "polyhedral", "clutch")
    for path in (ROOT / "fem").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                words = node.name.lower().split("_")
                assert not set(words) & set(subjects), f"{path.name}: {node.name}"


def test_every_package_s_init_imports_nothing():
    for package in ("analytic", "fem", "meshes", "verify", "reports"):
        for path in (ROOT / package).rglob("__init__.py"):
            tree = ast.parse(path.read_text("utf-8"))
            assert not [n for n in ast.walk(tree) if isinstance(n, ast.Import | ast.ImportFrom)]


def test_ids_of_cases_start_with_their_subject():
    subjects = ("ring", "contact", "spring", "freewheel", "polyhedral", "sprag", "rotor")
    for case in CASES:
        assert case.id.partition("-")[0] in subjects


def without_types(tree):
    """All nodes but those under `if TYPE_CHECKING`, whose imports never run."""
    for node in ast.iter_child_nodes(tree):
        if not (isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"):
            yield node
            yield from without_types(node)


def imports_of(path, modules):
    """Modules of the project that a file imports, inside functions too."""
    found = set()
    for node in without_types(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.ImportFrom):
            names = [f"{node.module}.{alias.name}" for alias in node.names] + [node.module or ""]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        else:
            continue
        found |= modules & set(names)
    return found


def test_no_module_imports_itself_by_way_of_others():
    paths = {
        ".".join(path.relative_to(ROOT).with_suffix("").parts): path
        for package in ("analytic", "fem", "meshes", "verify", "reports")
        for path in (ROOT / package).rglob("*.py")
        if path.name != "__init__.py"
    }
    graph = {name: imports_of(path, set(paths)) for name, path in paths.items()}
    TopologicalSorter(graph).prepare()  # CycleError names the circle
