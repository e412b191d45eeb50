"""The hash of the code behind a result: what changes it and what does not."""

import ast
import importlib
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import analytic
import fem
from verify.cases.registry import CASES
from verify.core import plain_code, source_code

# What a key is made of: a made-up case module, which reaches fem.made_up, which reaches
# fem.made_deep. Each variant is written to a folder of its own.

SOURCES = {
    "made_up_case": '''
"""A case."""
from verify.cases.made_up_inputs import WIDTH
from verify.cases.made_up_shapes import shape

FACTOR = 2.0
OTHER, PAIR = 1.0, 3.0
UNUSED = 4.0
TYPED: float = 13.0


class Section:
    """A section."""

    area = 5.0


def helper(x):
    """Twice x."""
    return FACTOR * PAIR * TYPED * Section.area * shape(x), WIDTH  # and more


def analytic(q):
    return 6.0


def solve(q, level, start=7.0):
    """Solve."""
    from fem.made_up import solved

    return solved(helper(level)) + start
''',
    "made_up_shapes": '''
def shape(x):
    """Where it is."""
    return 8.0 * x


def unused(x):
    return 9.0
''',
    "made_up_sizes": '''
SIZE = 14.0
''',
    "made_up": '''
"""A solver."""

from fem.made_deep import deep


def solved(x):
    """Solved."""
    if x < 0:
        raise ValueError("needs x > 0, got" f" {x}")
    assert x == x, "x is a number"
    return 10.0 * deep(x)
''',
    "made_deep": '''
def deep(x):
    return 11.0 * x


def other(x):
    return 16.0 * x
''',
    "made_moved": '''
def deep(x):
    return 11.0 * x


def other(x):
    return 16.0 * x
''',
    "made_apart": '''
def apart(x):
    return 12.0


def deep(x):
    return 12.0
''',
    "made_up_inputs": '''
from verify.core.inputs import quantity

WIDTH = quantity("1 mm", "mm", "w", "width of the part", gt=0)
''',
    "made_formula": '''
from analytic.made_modulus import MODULUS


def formula(x):
    return MODULUS * x
''',
    "made_modulus": '''
MODULUS = 15.0
''',
}  # fmt: skip


@pytest.fixture
def source(tmp_path_factory, monkeypatch):
    """Source hash of the made-up case's fem function, after replacements in its modules."""
    import verify.cases

    packages = [(package, package.__path__) for package in (analytic, fem, verify.cases)]

    def hashed(**changes):
        folder = tmp_path_factory.mktemp("variant")
        for name, text in SOURCES.items():
            for old, new in changes.get(name, ()):
                assert old in text
                text = text.replace(old, new)
            (folder / f"{name}.py").write_text(text, "utf-8")
        for package, path in packages:
            monkeypatch.setattr(package, "__path__", [*path, str(folder)])
        for name in SOURCES:
            for package in ("analytic", "fem", "verify.cases"):
                monkeypatch.delitem(sys.modules, f"{package}.{name}", raising=False)
        importlib.invalidate_caches()
        source_code.forget()
        module = importlib.import_module("verify.cases.made_up_case")
        return source_code.source_of(module.solve)

    yield hashed
    for name in SOURCES:
        for package in ("analytic", "fem", "verify.cases"):
            sys.modules.pop(f"{package}.{name}", None)
            vars(sys.modules[package]).pop(name, None)
    source_code.forget()


CASE_MODULE, SOLVER = "made_up_case", "made_up"


@pytest.mark.parametrize(
    ("module", "old", "new"),
    [
        pytest.param(CASE_MODULE, '"""Solve."""', '"""Solves it."""', id="docstring"),
        pytest.param(CASE_MODULE, '"""A section."""', "", id="docstring of a class"),
        pytest.param(CASE_MODULE, "FACTOR * PAIR", "(FACTOR  *  PAIR)", id="layout"),
        pytest.param(CASE_MODULE, "return 6.0", "return 6.5", id="formula"),
        pytest.param(CASE_MODULE, "UNUSED = 4.0", "UNUSED = 4.5", id="a name it does not use"),
        pytest.param("made_apart", "12.0", "12.5", id="a solver that it does not reach"),
        pytest.param(SOLVER, '"needs x > 0, got"', '"x must be positive, got"', id="a message"),
        pytest.param(SOLVER, 'f" {x}"', 'f" {x} mm"', id="a formatted message"),
        pytest.param(SOLVER, "from fem.made_deep import deep", "from fem.made_moved import deep",
                     id="a module that was moved"),
        pytest.param(CASE_MODULE, "# and more", "# and less", id="another comment"),
        pytest.param("made_up_inputs", '"width of the part"', '"breadth"', id="description"),
    ],
)  # fmt: skip
def test_what_changes_no_result_changes_no_key(module, old, new, source):
    assert source() == source(**{module: [(old, new)]})


@pytest.mark.parametrize(
    ("module", "old", "new"),
    [
        pytest.param(CASE_MODULE, "solved(helper(level))", "solved(helper(-level))", id="itself"),
        pytest.param(CASE_MODULE, "start=7.0", "start=7.5", id="its default"),
        pytest.param(CASE_MODULE, "def solve(q", "@(lambda f: f)\ndef solve(q", id="its decorator"),
        pytest.param(CASE_MODULE, "FACTOR = 2.0", "FACTOR = 2.5", id="a helper's constant"),
        pytest.param(CASE_MODULE, "= 1.0, 3.0", "= 1.0, 3.5", id="a constant of a pair"),
        pytest.param(CASE_MODULE, "area = 5.0", "area = 5.5", id="a class"),
        pytest.param("made_up_shapes", "8.0", "8.5", id="a helper of another case module"),
        pytest.param("made_deep", "11.0", "11.5", id="what its solver reaches"),
        pytest.param(SOLVER, "made_deep", "made_apart", id="another module with that name"),
        pytest.param(SOLVER, "raise ValueError", "raise KeyError", id="another exception"),
        pytest.param("made_up_inputs", '"1 mm"', '"2 mm"', id="default of an input"),
    ],
)
def test_what_may_change_a_result_changes_the_key(module, old, new, source):
    assert source() != source(**{module: [(old, new)]})


IMPORT = "from fem.made_deep import deep"


@pytest.mark.parametrize(
    "changes",
    [
        pytest.param([(IMPORT, "from fem import made_deep"), ("deep(x)", "made_deep.deep(x)")],
                     id="from fem import module"),
        pytest.param([(IMPORT, "import fem.made_deep"), ("deep(x)", "fem.made_deep.deep(x)")],
                     id="import fem.module"),
        pytest.param([(IMPORT, "import fem.made_deep as m"), ("deep(x)", "m.deep(x)")],
                     id="import as"),
        pytest.param([(IMPORT, "from . import made_deep"), ("deep(x)", "made_deep.deep(x)")],
                     id="from . import module"),
        pytest.param([(IMPORT, ""), ("    return 10", f"    {IMPORT}\n    return 10")],
                     id="inside a function"),
    ],
)  # fmt: skip
def test_a_module_is_reached_by_every_form_of_import(changes, source):
    deep = [("11.0", "11.5")]
    assert source(made_up=changes) != source(made_up=changes, made_deep=deep)


@pytest.mark.parametrize("use", ["from fem.made_up import passed", "from fem import made_up"])
def test_a_name_that_a_module_only_hands_on_stands_for_its_code(use, source):
    used = [("    from fem.made_up", f"    {use}\n    from fem.made_up")]
    first, second = (
        source(made_up_case=used, made_up=[(IMPORT, f"{IMPORT}\nfrom fem.{name} as passed")])
        for name in ("made_deep import deep", "made_deep import other")
    )
    third = source(
        made_up_case=used,
        made_up=[(IMPORT, f"{IMPORT}\nfrom fem.made_apart import deep as passed")],
    )
    assert len({first, second, third}) == 3


def test_modules_hashed_together_stand_for_their_code_in_each_other(source, monkeypatch):
    monkeypatch.setattr(source_code, "_counts", lambda _name: False)  # as modules of verify
    group = ["fem.made_deep", "fem.made_moved", "fem.made_apart", "fem.made_up"]

    def hashed(**changes):
        source(**changes)
        return source_code.group_hash(group)

    assert hashed(made_up=[("fem.made_deep", "fem.made_moved")]) == hashed()
    assert hashed(made_up=[("fem.made_deep", "fem.made_apart")]) != hashed()
    assert hashed(made_apart=[("12.0\n\n\ndef", "12.5\n\n\ndef")]) != hashed()


USE = "from analytic.made_formula import formula"
REFERENCE = [("helper(level)", "formula(level)"), ("    from fem", f"    {USE}\n    from fem")]
OTHER_SIDE = [("return 6.0", "return formula(6.0)"), ("FACTOR = 2.0", f"{USE}\nFACTOR = 2.0")]
SHAPED = [("def shape(x):", f"{USE}\n\n\ndef shape(x):")]
NAMED = [("def shape(x):", f"{USE}\n\nKNOWN = (formula,)\n\n\ndef shape(x: formula = 1.0):")]


@pytest.mark.parametrize("new", [{"made_formula": [("* x", "/ x")]},
                                 {"made_modulus": [("15.0", "15.5")]}])  # fmt: skip
def test_a_formula_counts_only_where_the_function_itself_imports_it_as_its_reference(new, source):
    assert source(made_up_case=REFERENCE) != source(made_up_case=REFERENCE, **new)
    every = ({"made_up_case": OTHER_SIDE}, {"made_up_shapes": SHAPED}, {"made_up_shapes": NAMED})
    for sides in every:  # a name of the other side stands for itself, wherever it is written
        assert source(**sides) == source(**sides, **new)


TAKE = "from verify.cases.made_up_shapes import shape"


@pytest.mark.parametrize(
    "changes",
    [
        pytest.param([], id="from module import name"),
        pytest.param([(TAKE, f"{TAKE} as shape_"), ("shape(x)", "shape_(x)")], id="import as"),
        pytest.param([(TAKE, "from verify.cases import made_up_shapes"),
                      ("shape(x)", "made_up_shapes.shape(x)")], id="from package import module"),
        pytest.param([(TAKE, "import verify.cases.made_up_shapes as m"),
                      ("shape(x)", "m.shape(x)")], id="import module as"),
        pytest.param([(TAKE, ""), ("    return FACTOR", f"    {TAKE}\n\n    return FACTOR")],
                     id="inside a function"),
    ],
)  # fmt: skip
def test_a_helper_of_another_case_module_is_reached(changes, source):
    other = [("8.0", "8.5")]
    assert source(made_up_case=changes) != source(made_up_case=changes, made_up_shapes=other)


CLOSURE = {  # what every engagement's table comes from, by way of other modules
    "analytic.contact.crown", "analytic.contact.slices", "analytic.ring.rotating",
    "analytic.ring.smeared", "analytic.sprag.closure", "analytic.sprag.compression",
    "analytic.sprag.laws", "analytic.sprag.parts", "analytic.sprag.table",
}  # fmt: skip

LOADED = """
import json, os, sys
import gmsh, meshio, numba, scipy.sparse.linalg, skfem
from verify.cases.registry import find

FORMULAS = f"{os.sep}analytic{os.sep}"

def project():
    return sorted(m for m in sys.modules if m.partition(".")[0] in ("fem", "meshes"))

def note(frame, event, _):
    if event == "call" and FORMULAS in frame.f_code.co_filename:
        called.add(frame.f_code.co_filename)

assert not project()
for name in sys.argv[1:]:
    if not os.fork():  # a process that has loaded the libraries, and nothing for another case
        case = find(name)
        inputs, called = case.inputs(), set()
        sys.setprofile(note)
        case.reference(inputs, case.levels[0])
        sys.setprofile(None)
        print(json.dumps([name, project(), sorted(called)]), flush=True)
        os._exit(0)
    os.wait()
"""


@pytest.fixture(scope="module")
def loaded():
    """What the coarsest level of each case loads of fem and meshes, and calls of analytic."""
    done = subprocess.run(
        [sys.executable, "-c", LOADED, *(case.id for case in CASES)],
        stdout=subprocess.PIPE, text=True, timeout=900, check=True, env=os.environ,
    )  # fmt: skip
    told = map(json.loads, done.stdout.splitlines())
    return {name: (set(modules), files) for name, modules, files in told}


@pytest.mark.soak
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_every_module_that_a_case_really_loads_is_in_its_key(case, loaded):
    loaded, called = loaded[case.id]
    _, reached = source_code.parts_of(case.reference)
    packages = {name.rpartition(".")[0] for name in loaded}  # they import nothing
    assert loaded - packages - {"fem", "meshes"} <= set(reached)
    root = Path(source_code.__file__).parents[2]
    formulas = {".".join(Path(f).relative_to(root).with_suffix("").parts) for f in called}
    assert formulas <= set(reached)
    if source_code.COMPILED in reached:  # an engagement's steps run over the closure's table
        assert set(reached) >= CLOSURE


def test_a_source_has_the_same_text_in_every_python():
    """As Python 3.11 writes it; 3.12 has a further field, 3.13 leaves empty ones out."""
    tree = ast.parse("def f(x): return g(x)")
    assert plain_code.plain(tree, {}) == (
        "Module(body=[FunctionDef(name='f', args=arguments(posonlyargs=[], args=[arg(arg='x')], "
        "kwonlyargs=[], kw_defaults=[], defaults=[]), body=[Return(value=Call("
        "func=Name(id='g', ctx=Load()), args=[Name(id='x', ctx=Load())], keywords=[]))], "
        "decorator_list=[])], type_ignores=[])"
    )
