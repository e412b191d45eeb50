"""Public names of packages: importable, documented with units, in the reference, and lazy."""

import ast
import inspect
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from tools import public_names

ROOT = public_names.ROOT
UNITS = re.compile(r"\[[^\]]+\]|consistent|\bSI\b|\brad\b|\bmetres\b|no units|dimensionless")


def words_of(thing, package):
    """Docstrings in which units may stand: of an object, its members, its module and package."""
    parts = [thing, sys.modules[thing.__module__], sys.modules[package]]
    if inspect.isclass(thing):
        parts += [v for v in vars(thing).values() if callable(v) or isinstance(v, property)]
    return "\n".join(inspect.getdoc(part) or "" for part in parts)


@pytest.mark.parametrize("package", public_names.packages())
def test_every_public_name_is_importable_and_documented_with_its_units(package):
    found = public_names.names(package)
    assert found
    assert set(found) <= set(dir(sys.modules[package]))
    for name, thing in found.items():
        scope = {}
        exec(f"from {package} import {name}", scope)
        assert scope[name] is thing
        assert inspect.getdoc(thing), name
        if isinstance(thing, ModuleType) or (
            inspect.isclass(thing) and issubclass(thing, Exception)
        ):
            continue
        assert UNITS.search(words_of(thing, package)), f"{package}.{name} states no units"


def test_the_reference_lists_every_public_name():
    assert public_names.PAGE.read_text("utf-8") == public_names.page(), (
        "run python -m tools.public_names"
    )


@pytest.mark.parametrize("package", public_names.packages())
def test_a_public_name_hides_no_module_and_the_stub_lists_what_it_imports(package):
    """`from fem.rotor import modes` is the module, before and after its first import."""
    folder = ROOT / package.replace(".", "/")
    tree = ast.parse((folder / "__init__.pyi").read_text("utf-8"))
    listed = ast.literal_eval(tree.body[-1].value)
    assert sorted(listed) == sorted(public_names.names(package))
    for name, thing in public_names.names(package).items():
        assert isinstance(thing, ModuleType) or not (folder / f"{name}.py").exists()
    code = ast.parse((folder / "__init__.py").read_text("utf-8")).body
    assert [type(node).__name__ for node in code] == ["Expr", "ImportFrom", "Assign"]


def test_no_two_classes_or_functions_share_a_public_name():
    homes = {}
    for package in public_names.packages():
        for name, thing in public_names.names(package).items():
            assert homes.setdefault(name, thing) is thing, f"{name} of {package} is taken"


@pytest.mark.parametrize("package", public_names.packages())
def test_the_names_of_version_0_1_are_importable_and_not_listed(package):
    module = sys.modules[package]
    folder = ROOT / package.replace(".", "/")
    body = ast.parse((folder / "__init__.pyi").read_text("utf-8")).body[:-1]
    for node in (node for node in body if isinstance(node, ast.Assign)):
        old, new = node.targets[0].id, node.value.id
        scope = {}
        exec(f"from {package} import {old}", scope)
        assert scope[old] is getattr(module, new)
        assert old not in module.__all__
        assert new in module.__all__


def test_an_unknown_name_is_an_error_that_names_the_package():
    import fem.plane

    with pytest.raises(AttributeError, match=r"module 'fem\.plane' has no attribute 'solve_plan'"):
        _ = fem.plane.solve_plan
    with pytest.raises(ImportError, match="solve_plan"):
        exec("from fem.plane import solve_plan")


def test_importing_a_module_or_one_name_imports_no_others():
    code = "\n".join(
        [
            "import sys, analytic.contact, fem.contact",
            "assert not [m for m in sys.modules if m.startswith(('numpy', 'scipy', 'skfem'))]",
            "from analytic.contact import contact_modulus",
            "found = {m for m in sys.modules if m.startswith('analytic.')}",
            "assert found <= {'analytic.contact', 'analytic.public', 'analytic.contact.two_bodies',"
            " 'analytic.contact.checks'}, found",
        ]
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    assert not done.returncode, done.stderr


def test_formulas_solvers_and_meshes_share_no_helper_although_theirs_are_alike():
    """They share no code; the three copies differ in their examples alone."""

    def code(top):
        tree = ast.parse(Path(ROOT / top / "public.py").read_text("utf-8"))
        lazily = next(node for node in tree.body if isinstance(node, ast.FunctionDef))
        lazily.body = lazily.body[1:]
        return ast.dump(tree)

    assert code("analytic") == code("fem") == code("meshes")
