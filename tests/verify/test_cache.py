"""Stored finite-element results: come back as they were, and only for what they were made of."""

import ast
import importlib
import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import analytic
import fem
from verify import cache
from verify.case import Case, FemResult
from verify.cases.registry import CASES
from verify.inputs import Inputs, quantity
from verify.shown import Field


class Beam(Inputs):
    L: float = quantity("1 m", "mm", "L", "length")
    b: float = quantity("2 mm", "mm", "b", "thickness")


def made_up(inputs, level):
    return FemResult(h=1 / level, values={"v": inputs.L})


CASE = Case(
    id="ring-made-up", title="", paper="", place="", lead="", inputs=Beam, analytic=lambda q: {},
    fem=made_up, levels=(1, 2, 4), checks=(), outputs=(),
)  # fmt: skip
RESULT = FemResult(
    h=0.1,
    values={"v": 1 / 3, "größe σ": -1e-300, "np": np.float64(2.5)},
    u_it={"v": 1e-17},
    arrays={"x, plane": np.arange(6.0).reshape(2, 3) / 7, "none": np.empty((0, 2)),
            "count": np.array([3, 1], dtype=np.int32)},
    fields=(
        Field(name="plane stress", points=np.eye(3) / 3, cells=np.array([[0, 1, 2]]),
              point_data={"u": np.ones((3, 2)), "T": np.arange(3.0)},
              cell_data={"stress": np.full((1, 4), np.pi)}, units={"u": "m"}),
        Field(name="empty", points=np.zeros((1, 2)), cells=np.zeros((0, 2), dtype=np.int64)),
    ),
)  # fmt: skip


def assert_same_arrays(left, right):
    assert list(left) == list(right)
    for name in left:
        assert left[name].dtype == right[name].dtype
        np.testing.assert_array_equal(left[name], right[name])


def assert_same(left, right):
    assert (left.h, left.values, left.u_it) == (right.h, right.values, right.u_it)
    assert_same_arrays(left.arrays, right.arrays)
    assert len(left.fields) == len(right.fields)
    for a, b in zip(left.fields, right.fields, strict=True):
        assert (a.name, a.units) == (b.name, b.units)
        assert_same_arrays({"p": a.points, "c": a.cells}, {"p": b.points, "c": b.cells})
        assert_same_arrays(a.point_data, b.point_data)
        assert_same_arrays(a.cell_data, b.cell_data)


def files(folder):
    return sorted(p for p in folder.rglob("*") if p.is_file())


# Storing and loading.


def test_a_stored_result_comes_back_bit_for_bit(tmp_path):
    assert cache.load(tmp_path, CASE, Beam(), 2) is None
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    assert_same(cache.load(tmp_path, CASE, Beam(), 2), RESULT)


def test_a_later_result_replaces_an_earlier_one(tmp_path):
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    cache.store(tmp_path, CASE, Beam(), 2, replace(RESULT, h=0.7))
    assert cache.load(tmp_path, CASE, Beam(), 2).h == 0.7
    assert len(files(tmp_path)) == 1


@pytest.mark.parametrize(
    ("case", "inputs", "level"),
    [
        pytest.param(CASE, Beam(), 4, id="another level"),
        pytest.param(CASE, Beam(L=1.0 + 1e-15), 2, id="another input"),
        pytest.param(CASE, Beam(L=Beam().b, b=Beam().L), 2, id="inputs exchanged"),
        pytest.param(replace(CASE, id="ring-other"), Beam(), 2, id="another case"),
        pytest.param(replace(CASE, fem=assert_same), Beam(), 2, id="another fem function"),
    ],
)
def test_a_result_is_found_for_nothing_but_what_it_is_of(case, inputs, level, tmp_path):
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    assert cache.load(tmp_path, case, inputs, level) is None


def test_cases_with_the_same_fem_function_have_keys_of_their_own():
    other = replace(CASE, id="ring-other")
    assert cache.key(CASE, Beam(), 2) != cache.key(other, Beam(), 2)


def test_equal_inputs_find_the_same_result(tmp_path):
    cache.store(tmp_path, CASE, Beam(L=2.0), 2, RESULT)
    assert cache.load(tmp_path, CASE, Beam(b=Beam().b, L=2.0), 2) is not None


@pytest.mark.parametrize("library", ["gmsh", "scikit-fem", "numpy", "scipy"])
def test_another_version_of_a_library_finds_nothing(library, tmp_path, monkeypatch):
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    right = cache.version
    monkeypatch.setattr(cache, "version", lambda name: right(name) + "x" * (name == library))
    assert cache.load(tmp_path, CASE, Beam(), 2) is None


def test_formulas_checks_and_words_of_a_case_find_the_same_result(tmp_path):
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    other = replace(CASE, title="new", analytic=lambda q: {"g": 1.0}, readings=("r",), levels=(2,))
    assert cache.load(tmp_path, other, Beam(), 2) is not None


# Damaged files, interrupted writers.


SMALL = FemResult(h=0.1, values={"v": 1 / 3}, arrays={"x": np.arange(3.0)})


@pytest.fixture
def damaged(tmp_path):
    """The bytes of a stored result, and what is loaded from other bytes in their place."""
    cache.store(tmp_path, CASE, Beam(), 2, SMALL)
    (path,) = files(tmp_path)
    whole = path.read_bytes()

    def load(content):
        path.write_bytes(content)
        return cache.load(tmp_path, CASE, Beam(), 2)

    return whole, load


def test_a_torn_file_is_ignored_wherever_it_is_torn(damaged):
    whole, load = damaged
    assert_same(load(whole), SMALL)
    lengths = [*range(0, len(whole), 7), len(whole) - 1]
    assert not [n for n in lengths if load(whole[:n]) is not None]


def test_a_file_with_a_wrong_bit_is_ignored_or_still_right(damaged):
    """Members of a zip carry a checksum, its directory does not."""
    whole, load = damaged
    for at in range(len(whole)):
        wrong = bytearray(whole)
        wrong[at] ^= 1  # flags: a password, methods: another compression, and so on
        found = load(bytes(wrong))
        if found is not None:
            assert_same(found, SMALL)


@pytest.mark.parametrize(
    "content",
    [
        pytest.param(b"", id="empty"),
        pytest.param(b"no zip at all", id="text"),
        pytest.param(b"\x93NUMPY\x01\x00", id="start of an array"),
        pytest.param(b"PK\x05\x06" + bytes(18), id="a zip without members"),
        pytest.param(b"\x80\x04K\x01.", id="a pickle"),
    ],
)
def test_what_is_no_stored_result_is_ignored(content, damaged):
    _, load = damaged
    assert load(content) is None


def test_a_folder_in_place_of_a_file_is_ignored(tmp_path):
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    (path,) = files(tmp_path)
    path.unlink()
    path.mkdir()
    assert cache.load(tmp_path, CASE, Beam(), 2) is None


@pytest.mark.parametrize("error", [KeyboardInterrupt, OSError, MemoryError])
def test_an_interrupted_store_leaves_no_file_and_shows_none_meanwhile(error, tmp_path, monkeypatch):
    def half(file, **_):
        file.write(b"PK\x03\x04 half of it")
        file.flush()
        assert cache.load(tmp_path, CASE, Beam(), 2) is None
        raise error

    monkeypatch.setattr(np, "savez", half)
    with pytest.raises(error):
        cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    assert files(tmp_path) == []


def test_an_interrupted_store_leaves_the_earlier_result(tmp_path, monkeypatch):
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    monkeypatch.setattr(np, "savez", lambda file, **_: file.write(b"x") and 1 / 0)
    with pytest.raises(ZeroDivisionError):
        cache.store(tmp_path, CASE, Beam(), 2, replace(RESULT, h=0.7))
    monkeypatch.undo()
    assert_same(cache.load(tmp_path, CASE, Beam(), 2), RESULT)


def test_objects_are_never_pickled(tmp_path):
    with pytest.raises(ValueError, match=r"[Oo]bject arrays"):
        cache.store(tmp_path, CASE, Beam(), 2, replace(RESULT, arrays={"o": np.array([{}])}))
    assert files(tmp_path) == []


def test_the_environment_may_name_another_place(tmp_path, monkeypatch):
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path))
    assert cache.default_folder() == tmp_path
    monkeypatch.delenv("FREEWHEEL_CACHE")
    assert cache.default_folder().parts[-2:] == (".cache", "fem")


# What a key is made of: a made-up case module, which reaches fem.made_up, which reaches
# fem.made_deep. Each variant is written to a folder of its own.

SOURCES = {
    "made_up_case": '''
"""A case."""
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
    return FACTOR * PAIR * TYPED * Section.area * shape(x)  # and more


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
    return 10.0 * deep(x)
''',
    "made_deep": '''
def deep(x):
    return 11.0 * x
''',
    "made_apart": '''
def apart(x):
    return 12.0
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
        cache.source_of.cache_clear()
        cache._read.cache_clear()  # processes read a module once; here its file changes
        module = importlib.import_module("verify.cases.made_up_case")
        return cache.source_of(module.solve)

    yield hashed
    for name in SOURCES:
        for package in ("analytic", "fem", "verify.cases"):
            sys.modules.pop(f"{package}.{name}", None)
            vars(sys.modules[package]).pop(name, None)
    cache.source_of.cache_clear()
    cache._read.cache_clear()


CASE_MODULE, SOLVER = "made_up_case", "made_up"


@pytest.mark.parametrize(
    ("module", "old", "new"),
    [
        pytest.param(CASE_MODULE, '"""Solve."""', '"""Solves it."""', id="docstring"),
        pytest.param(CASE_MODULE, '"""Solve."""', "", id="no docstring"),
        pytest.param(CASE_MODULE, '"""A section."""', "", id="docstring of a class"),
        pytest.param(CASE_MODULE, "  # and more", "", id="comment"),
        pytest.param(CASE_MODULE, "FACTOR * PAIR", "(FACTOR  *  PAIR)", id="layout"),
        pytest.param(CASE_MODULE, "return 6.0", "return 6.5", id="formula"),
        pytest.param(CASE_MODULE, "UNUSED = 4.0", "UNUSED = 4.5", id="a name it does not use"),
        pytest.param(SOLVER, '"""Solved."""', '"""New."""', id="docstring of a solver"),
        pytest.param(SOLVER, '"""A solver."""', "# A solver.", id="docstring of a solver's module"),
        pytest.param("made_deep", "def deep(x):", "def deep(x):  # new", id="comment of a solver"),
        pytest.param("made_apart", "12.0", "12.5", id="a solver that it does not reach"),
    ],
)
def test_what_changes_no_result_changes_no_key(module, old, new, source):
    assert source() == source(**{module: [(old, new)]})


@pytest.mark.parametrize(
    ("module", "old", "new"),
    [
        pytest.param(CASE_MODULE, "solved(helper(level))", "solved(helper(-level))", id="itself"),
        pytest.param(CASE_MODULE, "start=7.0", "start=7.5", id="its default"),
        pytest.param(CASE_MODULE, "def solve(q", "@(lambda f: f)\ndef solve(q", id="its decorator"),
        pytest.param(CASE_MODULE, "return FACTOR", "return -FACTOR", id="a helper"),
        pytest.param(CASE_MODULE, "FACTOR = 2.0", "FACTOR = 2.5", id="a helper's constant"),
        pytest.param(CASE_MODULE, "TYPED: float = 13.0", "TYPED: float = 13.5", id="with a type"),
        pytest.param(CASE_MODULE, "= 1.0, 3.0", "= 1.0, 3.5", id="a constant of a pair"),
        pytest.param(CASE_MODULE, "area = 5.0", "area = 5.5", id="a class"),
        pytest.param("made_up_shapes", "8.0", "8.5", id="a helper of another case module"),
        pytest.param(SOLVER, "10.0", "10.5", id="its solver"),
        pytest.param("made_deep", "11.0", "11.5", id="what its solver reaches"),
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
        pytest.param([(IMPORT, "from .made_deep import deep")], id="from .module import"),
        pytest.param([(IMPORT, "from . import made_deep"), ("deep(x)", "made_deep.deep(x)")],
                     id="from . import module"),
        pytest.param([(IMPORT, ""), ("    return 10", f"    {IMPORT}\n    return 10")],
                     id="inside a function"),
        pytest.param([(IMPORT, f"if True:\n    {IMPORT}")], id="under a condition"),
    ],
)  # fmt: skip
def test_a_module_is_reached_by_every_form_of_import(changes, source):
    deep = [("11.0", "11.5")]
    assert source(made_up=changes) != source(made_up=changes, made_deep=deep)


USE = "from analytic.made_formula import formula"
REFERENCE = [("helper(level)", "formula(level)"), ("    from fem", f"    {USE}\n    from fem")]
OTHER_SIDE = [("return 6.0", "return formula(6.0)"), ("FACTOR = 2.0", f"{USE}\nFACTOR = 2.0")]
SHAPED = [("def shape(x):", f"{USE}\n\n\ndef shape(x):")]


@pytest.mark.parametrize("new", [{"made_formula": [("* x", "/ x")]},
                                 {"made_modulus": [("15.0", "15.5")]}])  # fmt: skip
def test_a_formula_counts_only_where_the_function_itself_imports_it_as_its_reference(new, source):
    assert source(made_up_case=REFERENCE) != source(made_up_case=REFERENCE, **new)
    for sides in ({"made_up_case": OTHER_SIDE}, {"made_up_shapes": SHAPED}):
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


def test_a_helper_s_helper_in_a_third_case_module_is_reached(source):
    sized = [
        ("def shape(x):", "from verify.cases.made_up_sizes import SIZE\n\n\ndef shape(x):"),
        ("8.0 * x", "SIZE * x"),
    ]
    here = source(made_up_shapes=sized)
    assert here != source(made_up_shapes=sized, made_up_sizes=[("14.0", "14.5")])


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
        case.fem(inputs, case.levels[0])
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


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_every_module_that_a_case_really_loads_is_in_its_key(case, loaded):
    loaded, called = loaded[case.id]
    _, reached = cache.parts_of(case.fem)
    packages = {name.rpartition(".")[0] for name in loaded}  # they import nothing
    assert loaded - packages - {"fem", "meshes"} <= set(reached)
    root = Path(cache.__file__).parents[1]
    formulas = {".".join(Path(f).relative_to(root).with_suffix("").parts) for f in called}
    assert formulas <= set(reached)
    if cache.COMPILED in reached:  # an engagement's steps run over the closure's table
        assert set(reached) >= CLOSURE


@pytest.mark.parametrize(
    "case",
    [c for c in CASES if c.id.startswith(("ring-", "contact-flat", "contact-pair", "contact-ring"))
     or c.id in ("polyhedral-ring", "polyhedral-locking", "spring-accordion", "rotor-sprag")],
    ids=lambda case: case.id,
)  # fmt: skip
def test_a_changed_formula_solves_nothing_anew_where_finite_elements_take_none(case):
    assert not [name for name in cache.parts_of(case.fem)[1] if name.startswith("analytic")]


def test_a_source_has_the_same_text_in_every_python():
    """As Python 3.11 writes it; 3.12 has a further field, 3.13 leaves empty ones out."""
    tree = ast.parse("def f(x): return g(x)")
    assert cache.dump(tree) == (
        "Module(body=[FunctionDef(name='f', args=arguments(posonlyargs=[], args=[arg(arg='x')], "
        "kwonlyargs=[], kw_defaults=[], defaults=[]), body=[Return(value=Call("
        "func=Name(id='g', ctx=Load()), args=[Name(id='x', ctx=Load())], keywords=[]))], "
        "decorator_list=[])], type_ignores=[])"
    )
