"""The hash of the code behind a result: changes with and without effect."""

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
import verify.cases
from verify.cases.registry import CASES
from verify.core import module_syntax, plain_code, source_code, source_memory
from verify.form.adapter import adapted
from verify.form.code_tex import tex_of

# A made-up case, which reaches fem.made_up and fem.made_deep, and a case that is one class.
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
    "made_alone": '''
def alone(x):
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
    "made_bar": '''
from verify.case import Case, Quantity, approximation, given
from verify.case import Expected

EXPECTED = Expected(-0.01, 0.03, "book")

class Bar(Case):
    """A bar in tension."""

    title = "Bar"
    source = "belcin"

    d: float = given("10 mm", "mm", "d", "diameter", gt=0)
    F: float = given("1 kN", "kN", "F", "force")

    @Quantity("r", "mm", "radius", role="geometry")
    def radius(self) -> float:
        return self.d / 2.0

    @Quantity("A", "mm^2", "area", role="geometry")
    def area(self) -> float:
        return 3.14 * self.radius**2

    @Quantity("σ", "MPa", "stress", equation="1", when=lambda q: q.F > 0)
    def sigma(self) -> float:
        return self.F / self.area * 1.0

    def reference(self, level):
        from verify.cases.made_bar_reference import solve

        return solve(self, level)

    def comparisons(self):
        yield approximation(Bar.sigma, order=2, expected=EXPECTED)
''',
    "made_bar_reference": """
from verify.case import solved

def solve(q, level):
    return solved(1 / level, sigma=q.F / q.area)

def error(q, stress):
    # of the formula; no part of a solution, in which reading it is an error
    return q.sigma / stress - 1
""",
}  # fmt: skip


PUBLIC_PACKAGE = {  # fem.made_public
    "__init__.py": "",
    "__init__.pyi": "from fem.made_alone import alone as further\nfrom fem.made_deep import deep\n",
    "part.py": "def part(x):\n    return 17.0 * x\n",
}


@pytest.fixture
def module(tmp_path_factory, monkeypatch):
    """A module of the made-up cases, after replacements in the sources."""
    packages = [(package, package.__path__) for package in (analytic, fem, verify.cases)]

    def gone():
        for name in (*SOURCES, "made_public"):
            for package, _ in packages:
                sys.modules.pop(f"{package.__name__}.{name}", None)
                vars(package).pop(name, None)
        source_code.forget()

    def written(name, changes):
        folder = tmp_path_factory.mktemp("variant")
        for one, text in SOURCES.items():
            for old, new in changes.get(one, ()):
                assert old in text
                text = text.replace(old, new)
            (folder / f"{one}.py").write_text(text, "utf-8")
        public = folder / "made_public"
        public.mkdir()
        for file, text in PUBLIC_PACKAGE.items():
            (public / file).write_text(text, "utf-8")
        for package, path in packages:
            monkeypatch.setattr(package, "__path__", [*path, str(folder)])
        gone()
        importlib.invalidate_caches()
        return importlib.import_module(f"verify.cases.{name}")

    yield written
    gone()


@pytest.fixture
def source(module):
    """Source hash of the made-up case's reference, after replacements in its modules."""
    return lambda **changes: source_code.source_of(module("made_up_case", changes).solve)


CASE_MODULE, SOLVER = "made_up_case", "made_up"

SAME = [
    (CASE_MODULE, '"""Solve."""', '"""Solves it."""'),
    (CASE_MODULE, '"""A section."""', ""),
    (CASE_MODULE, "FACTOR * PAIR", "(FACTOR  *  PAIR)"),
    (CASE_MODULE, "# and more", "# and less"),
    (CASE_MODULE, "return 6.0", "return 6.5"),  # the formula
    (CASE_MODULE, "UNUSED = 4.0", "UNUSED = 4.5"),
    ("made_alone", "12.0", "12.5"),  # a solver that it does not reach
    (SOLVER, '"needs x > 0, got"', '"x must be positive, got"'),
    (SOLVER, 'f" {x}"', 'f" {x} mm"'),
    (SOLVER, "from fem.made_deep import deep", "from fem.made_moved import deep"),
    ("made_up_inputs", '"width of the part"', '"breadth"'),
]
OTHER = [
    (CASE_MODULE, "solved(helper(level))", "solved(helper(-level))"),
    (CASE_MODULE, "start=7.0", "start=7.5"),
    (CASE_MODULE, "def solve(q", "@(lambda f: f)\ndef solve(q"),
    (CASE_MODULE, "FACTOR = 2.0", "FACTOR = 2.5"),
    (CASE_MODULE, "= 1.0, 3.0", "= 1.0, 3.5"),
    (CASE_MODULE, "area = 5.0", "area = 5.5"),
    ("made_up_shapes", "8.0", "8.5"),
    ("made_deep", "11.0", "11.5"),
    (SOLVER, "raise ValueError", "raise KeyError"),
    (SOLVER, "made_deep", "made_alone"),  # another module with that name
    ("made_up_inputs", '"1 mm"', '"2 mm"'),
]


def test_what_changes_no_result_changes_no_key_and_what_may_change_one_does(source):
    key = source()
    assert [source(**{name: [(old, new)]}) == key for name, old, new in SAME] == [True] * len(SAME)
    keys = {source(**{name: [(old, new)]}) for name, old, new in OTHER}
    assert len(keys | {key}) == len(OTHER) + 1


IMPORT = "from fem.made_deep import deep"
TAKE = "from verify.cases.made_up_shapes import shape"
DEEP = "made_deep.deep(x)"


def test_a_module_is_reached_by_every_form_of_import(source):
    for name, changes in (
        (SOLVER, [(IMPORT, "from fem import made_deep"), ("deep(x)", DEEP)]),
        (SOLVER, [(IMPORT, "import fem.made_deep"), ("deep(x)", f"fem.{DEEP}")]),
        (SOLVER, [(IMPORT, "import fem.made_deep as m"), ("deep(x)", "m.deep(x)")]),
        (SOLVER, [(IMPORT, "from . import made_deep"), ("deep(x)", DEEP)]),
        (SOLVER, [(IMPORT, ""), ("    return 10", f"    {IMPORT}\n    return 10")]),
        (CASE_MODULE, [(TAKE, f"{TAKE} as shape_"), ("shape(x)", "shape_(x)")]),
        (CASE_MODULE, [(TAKE, "import verify.cases.made_up_shapes as m"),
                       ("shape(x)", "m.shape(x)")]),
    ):  # fmt: skip
        changed = {
            SOLVER: {"made_deep": [("11.0", "11.5")]},
            CASE_MODULE: {"made_up_shapes": [("8.0", "8.5")]},
        }
        assert source(**{name: changes}) != source(**{name: changes}, **changed[name])


PUBLIC = "from fem.made_public import deep"


def test_a_public_name_of_a_package_counts_as_the_one_of_its_module(source):
    """An import of one name reaches its module alone, the package as a whole all of them."""
    one = {SOLVER: [(IMPORT, PUBLIC)]}
    assert source(**one) == source()
    for name, changes in (
        ("one", [(IMPORT, PUBLIC)]),
        ("other name", [(IMPORT, "from fem.made_public import further as deep")]),
        ("module", [(IMPORT, "from fem.made_public import part"), ("deep(x)", "part.part(x)")]),
        ("package", [(IMPORT, "from fem import made_public as m"), ("deep(x)", "m.deep(x)")]),
        ("dotted", [(IMPORT, "import fem.made_public.part"),
                    ("deep(x)", "fem.made_public.deep(x)")]),
        ("all", [(IMPORT, "from fem.made_public import *")]),
    ):  # fmt: skip
        reached = {SOLVER: changes}
        deep = {"made_deep": [("11.0", "11.5")]}
        alone = {"made_alone": [("12.0\n\ndef", "12.5\n\ndef")]}
        key = source(**reached)
        assert (source(**reached, **deep) == key) == (name in ("other name", "module")), name
        whole = name in ("package", "dotted", "all")
        assert (source(**reached, **alone) == key) == (name != "other name" and not whole), name


def test_modules_hashed_together_stand_for_their_code_in_each_other(source, monkeypatch):
    monkeypatch.setattr(source_code, "_counts", lambda _name: False)  # as modules of verify
    group = ["fem.made_deep", "fem.made_moved", "fem.made_alone", "fem.made_up"]

    def hashed(**changes):
        source(**changes)
        return source_code.group_hash(group)

    assert hashed(made_up=[("fem.made_deep", "fem.made_moved")]) == hashed()
    assert hashed(made_up=[("fem.made_deep", "fem.made_alone")]) != hashed()
    assert hashed(made_alone=[("12.0\n\ndef", "12.5\n\ndef")]) != hashed()


USE = "from analytic.made_formula import formula"
REFERENCE = [("helper(level)", "formula(level)"), ("    from fem", f"    {USE}\n    from fem")]
OTHER_SIDE = [("return 6.0", "return formula(6.0)"), ("FACTOR = 2.0", f"{USE}\nFACTOR = 2.0")]
NAMED = [("def shape(x):", f"{USE}\n\nKNOWN = (formula,)\n\n\ndef shape(x: formula = 1.0):")]


def test_a_formula_counts_only_where_the_function_itself_imports_it_as_its_reference(source):
    for new in ({"made_formula": [("* x", "/ x")]}, {"made_modulus": [("15.0", "15.5")]}):
        assert source(made_up_case=REFERENCE) != source(made_up_case=REFERENCE, **new)
        # a name of the other side stands for itself, wherever it is written
        for sides in ({"made_up_case": OTHER_SIDE}, {"made_up_shapes": NAMED}):
            assert source(**sides) == source(**sides, **new)


# A case that is one class

BOTH = {"formulas", "reference"}


def test_a_change_of_a_class_changes_the_keys_of_the_sides_that_read_it(module):
    def keys(**changes):
        case = adapted(module("made_bar", changes).Bar)
        return {
            "formulas": source_code.whole_source_of(case.analytic),
            "reference": source_code.source_of(case.reference),
        }

    before = keys()
    for name, old, new, changed in (
        ("made_bar", "3.14 *", "3.15 *", BOTH),  # geometry that the reference reads
        ("made_bar", "d / 2.0", "d / 2.5", BOTH),  # geometry under that
        ("made_bar", "lambda q: q.F", "lambda q: -q.F", {"formulas"}),
        ("made_bar", "area * 1.0", "area * 1.5", {"formulas"}),
        ("made_bar", "0.03", "0.04", {"formulas"}),  # bound of a comparison
        ("made_bar", '"10 mm"', '"11 mm"', BOTH),
        ("made_bar", "in tension", "under a pull", set()),
        ("made_bar_reference", "q.F / q.area", "2 * q.F / q.area", {"reference"}),
    ):
        after = keys(**{name: [(old, new)]})
        assert {side for side in BOTH if before[side] != after[side]} == changed, (old, new)


# The cases of the suite

CLOSURE = {  # what every engagement's table comes from, by other modules
    "analytic.contact.crown", "analytic.contact.slices", "analytic.ring.rotating",
    "analytic.ring.smeared", "analytic.sprag.closure", "analytic.sprag.compression",
    "analytic.sprag.laws", "analytic.sprag.parts", "analytic.sprag.table",
}  # fmt: skip

LOADED = """
import inspect, json, os, sys
import gmsh, meshio, numba, scipy.sparse.linalg, skfem
from verify.cases.registry import find

FORMULAS = f"{os.sep}analytic{os.sep}"

def project():
    return sorted(m for m in sys.modules if m.partition(".")[0] in ("fem", "meshes"))

def note(frame, event, _):
    code = frame.f_code  # bodies of modules and classes run when imported, and compute nothing
    if event == "call" and FORMULAS in code.co_filename and code.co_flags & inspect.CO_OPTIMIZED:
        called.add(code.co_filename)

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


@pytest.mark.soak
def test_every_module_that_a_case_really_loads_is_in_its_key():
    """What the coarsest level of each case loads of fem and meshes, and calls of analytic."""
    done = subprocess.run(
        [sys.executable, "-c", LOADED, *(case.id for case in CASES)],
        stdout=subprocess.PIPE, text=True, timeout=900, check=True, env=os.environ,
    )  # fmt: skip
    found = {name: more for name, *more in map(json.loads, done.stdout.splitlines())}
    root = Path(source_code.__file__).parents[2]
    for case in CASES:
        loaded, called = map(set, found[case.id])
        reached = set(source_code.parts_of(case.reference)[1])
        packages = {name.rpartition(".")[0] for name in loaded}  # they import nothing
        packages |= {"fem.public", "meshes.public", "analytic.public"}  # nor have they a result
        called.discard(str(root / "analytic" / "public.py"))
        assert loaded - packages - {"fem", "meshes"} <= reached, case.id
        formulas = {".".join(Path(f).relative_to(root).with_suffix("").parts) for f in called}
        assert formulas <= reached, case.id
        if source_code.COMPILED in reached:  # an engagement's steps run over the closure's table
            assert reached >= CLOSURE, case.id


def test_one_thread_at_a_time_makes_syntax_trees(monkeypatch):
    """Two at once end a run of `verify`, now and then, in a SystemError of Python 3.11."""
    alone, parse = [], ast.parse

    def watched(*source, **more):
        alone.append(module_syntax._PARSING.locked())
        return parse(*source, **more)

    def mean(q):
        return (q.a + q.b) / 2

    monkeypatch.setattr(ast, "parse", watched)
    module_syntax.tree.__wrapped__("analytic.ring.lame")
    tex_of(mean, {"q.a": "a", "q.b": "b"})
    monkeypatch.undo()  # pytest makes trees, too
    assert alone == [True] * 2


def test_a_source_has_the_same_text_in_every_python():
    """As Python 3.11 writes it; 3.12 has a further field, 3.13 leaves empty ones out."""
    tree = ast.parse("def f(x): return g(x)")
    assert plain_code.plain(tree, {}) == (
        "Module(body=[FunctionDef(name='f', args=arguments(posonlyargs=[], args=[arg(arg='x')], "
        "kwonlyargs=[], kw_defaults=[], defaults=[]), body=[Return(value=Call("
        "func=Name(id='g', ctx=Load()), args=[Name(id='x', ctx=Load())], keywords=[]))], "
        "decorator_list=[])], type_ignores=[])"
    )


# Hashes are remembered while no file changes that they may depend on


def test_what_was_found_is_found_by_the_next_process_until_a_file_changes(tmp_path, monkeypatch):
    monkeypatch.setattr(source_memory, "_used", [])
    calls = []

    def begun():
        source_memory._used[:] = [source_memory.Memory(tmp_path)]

    def remembered(name):
        return source_memory.remembered(name, adapted, lambda: calls.append(1) or len(calls))

    begun()
    assert remembered("x") == 1
    source_memory.share()
    begun()
    assert (remembered("x"), remembered("y")) == (1, 2)
    monkeypatch.setattr(source_memory, "digest_of", lambda *_modules: "of other files")
    begun()
    assert remembered("x") == 3
