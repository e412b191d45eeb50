"""Stored finite-element results: come back as they were, and only for what they were made of."""

from dataclasses import replace

import numpy as np
import pytest

from verify.core.case import Case, FemResult
from verify.core.figures import Field
from verify.core.inputs import Inputs, quantity
from verify.core.store import Store
from verify.jobs import cache


class Beam(Inputs):
    L: float = quantity("1 m", "mm", "L", "length")
    b: float = quantity("2 mm", "mm", "b", "thickness")


def made_up(inputs, level):
    return FemResult(h=1 / level, values={"v": inputs.L})


CASE = Case(
    id="ring-made-up", title="", paper="", place="", lead="", inputs=Beam, analytic=lambda q: {},
    reference=made_up, levels=(1, 2, 4), checks=(), outputs=(),
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


def entries(folder):
    return sum(group.entries for group in Store(folder).groups())


# Storing and loading.


def test_a_stored_result_comes_back_bit_for_bit(tmp_path):
    assert cache.load(tmp_path, CASE, Beam(), 2) is None
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    assert_same(cache.load(tmp_path, CASE, Beam(), 2), RESULT)


@pytest.mark.parametrize(
    ("case", "inputs", "level"),
    [
        pytest.param(CASE, Beam(), 4, id="another level"),
        pytest.param(CASE, Beam(L=1.0 + 1e-15), 2, id="another input"),
        pytest.param(CASE, Beam(L=Beam().b, b=Beam().L), 2, id="inputs exchanged"),
        pytest.param(replace(CASE, id="ring-other"), Beam(), 2, id="another case"),
        pytest.param(replace(CASE, reference=assert_same), Beam(), 2, id="another fem function"),
    ],
)
def test_a_result_is_found_for_nothing_but_what_it_is_of(case, inputs, level, tmp_path):
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    assert cache.load(tmp_path, case, inputs, level) is None


@pytest.mark.parametrize("library", ["gmsh", "scipy"])
def test_another_version_of_a_library_finds_nothing(library, tmp_path, monkeypatch):
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    right = cache.version
    monkeypatch.setattr(cache, "version", lambda name: right(name) + "x" * (name == library))
    assert cache.load(tmp_path, CASE, Beam(), 2) is None


# Damaged files, interrupted writers.


SMALL = FemResult(h=0.1, values={"v": 1 / 3}, arrays={"x": np.arange(3.0)})


@pytest.fixture
def damaged(tmp_path):
    """The bytes of a stored result, and what is loaded from other bytes in their place."""
    cache.store(tmp_path, CASE, Beam(), 2, SMALL)
    store, key = Store(tmp_path), cache.key(CASE, Beam(), 2)
    whole = store.one(cache.KIND, key)

    def load(content):
        store.store(cache.KIND, CASE.id, {key: content})
        return cache.load(tmp_path, CASE, Beam(), 2)

    return whole, load


def test_a_torn_entry_is_ignored_wherever_it_is_torn(damaged):
    whole, load = damaged
    assert_same(load(whole), SMALL)
    lengths = [*range(0, len(whole), 29), len(whole) - 1]
    assert not [n for n in lengths if load(whole[:n]) is not None]


@pytest.mark.parametrize(
    "content",
    [
        pytest.param(b"", id="empty"),
        pytest.param(b"no zip at all", id="text"),
        pytest.param(b"\x80\x04K\x01.", id="a pickle"),
    ],
)
def test_what_is_no_stored_result_is_ignored(content, damaged):
    _, load = damaged
    assert load(content) is None


@pytest.mark.parametrize("error", [KeyboardInterrupt, OSError])
def test_an_interrupted_store_leaves_the_earlier_result(error, tmp_path, monkeypatch):
    def half(file, **_):
        file.write(b"PK\x03\x04 half of it")
        raise error

    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    monkeypatch.setattr(np, "savez", half)
    with pytest.raises(error):
        cache.store(tmp_path, CASE, Beam(), 2, replace(RESULT, h=0.7))
    with pytest.raises(error):
        cache.store(tmp_path, CASE, Beam(), 4, RESULT)
    assert_same(cache.load(tmp_path, CASE, Beam(), 2), RESULT)
    assert entries(tmp_path) == 1
