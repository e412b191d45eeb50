"""Stored finite-element results and files are complete, and found for equal inputs and code."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from verify.core.case import Case, FemResult
from verify.core.figures import Field
from verify.core.files import PREFIX, write_whole
from verify.core.inputs import Inputs, quantity, table
from verify.core.store import Store
from verify.jobs import cache


class Post(Inputs):
    k: float = quantity("2 N/mm", "N/mm", "k", "stiffness")


class Beam(Inputs):
    L: float = quantity("1 m", "mm", "L", "length")
    b: float = quantity("2 mm", "mm", "b", "thickness")
    posts: tuple[Post, ...] = table((Post(),), "Posts.")


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
SMALL = FemResult(h=0.1, values={"v": 1 / 3}, arrays={"x": np.arange(3.0)})


def exactly(arrays):
    """All that arrays hold, for comparison to the last bit."""
    return {name: (a.dtype, a.shape, a.tobytes()) for name, a in arrays.items()}


def contents(result):
    fields = [
        (f.name, f.units, exactly({"p": f.points, "c": f.cells}), exactly(f.point_data),
         exactly(f.cell_data))
        for f in result.fields
    ]  # fmt: skip
    return result.h, result.values, result.u_it, exactly(result.arrays), fields


def test_a_stored_result_comes_back_bit_for_bit(tmp_path):
    assert cache.load(tmp_path, CASE, Beam(), 2) is None
    cache.store(tmp_path, CASE, Beam(), 2, RESULT)
    assert contents(cache.load(tmp_path, CASE, Beam(), 2)) == contents(RESULT)


@pytest.mark.parametrize(
    ("case", "inputs", "level"),
    [
        pytest.param(CASE, Beam(), 4, id="another level"),
        pytest.param(CASE, Beam(L=1.0 + 1e-15), 2, id="another input"),
        pytest.param(CASE, Beam(L=Beam().b, b=Beam().L), 2, id="inputs exchanged"),
        pytest.param(CASE, Beam(posts=(Post(k=2e3 + 1e-6),)), 2, id="another entry of a table"),
        pytest.param(replace(CASE, id="ring-other"), Beam(), 2, id="another case"),
        pytest.param(replace(CASE, reference=contents), Beam(), 2, id="another fem function"),
    ],
)
def test_a_result_is_found_for_nothing_but_what_it_is_of(
    case, inputs, level, tmp_path, monkeypatch
):
    cache.store(tmp_path, CASE, Beam(), 2, SMALL)
    assert cache.load(tmp_path, case, inputs, level) is None
    right = cache.version
    for library in ("gmsh", "scipy"):
        monkeypatch.setattr(cache, "version", lambda n, x=library: right(n) + "x" * (n == x))
        assert cache.load(tmp_path, CASE, Beam(), 2) is None
    monkeypatch.undo()
    assert contents(cache.load(tmp_path, CASE, Beam(), 2)) == contents(SMALL)


def test_a_damaged_entry_is_ignored(tmp_path):
    cache.store(tmp_path, CASE, Beam(), 2, SMALL)
    store, key = Store(tmp_path), cache.key(CASE, Beam(), 2)
    whole = store.one(cache.KIND, key)
    for content in (whole[: len(whole) // 2], whole[:-1], b"", b"no zip", b"\x80\x04K\x01."):
        store.store(cache.KIND, CASE.id, {key: content})
        assert cache.load(tmp_path, CASE, Beam(), 2) is None


# Files that are whole or not there

WRITING = """
import sys
from pathlib import Path
from verify.core.files import write_whole
def slowly(file):
    file.write(b"half"); file.flush()
    print("writing", flush=True)
    sys.stdin.readline()
write_whole(Path(sys.argv[1]) / "entry", slowly)
"""


def test_a_killed_writer_leaves_the_earlier_file_and_one_that_fails_nothing(tmp_path):
    def fail(file):
        file.write(b"half")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_whole(tmp_path / "entry", fail)
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "entry").write_bytes(b"earlier")
    with subprocess.Popen(
        [sys.executable, "-c", WRITING, tmp_path],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    ) as process:  # fmt: skip
        assert process.stdout.readline() == "writing\n"
        assert len([p for p in tmp_path.iterdir() if p.name.startswith(PREFIX)]) == 1
        process.kill()
        process.communicate()
    assert (tmp_path / "entry").read_bytes() == b"earlier"
    write_whole(tmp_path / "entry", lambda file: file.write(b"half"))
    assert (tmp_path / "entry").read_bytes() == b"half"
