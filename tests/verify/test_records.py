"""Records of measurements: current for what made them, whole or absent, readable in a diff."""

import json
import time

import pytest

from verify.jobs import records
from verify.jobs.records import Records

RECORDS = Records("made-up")
MADE_BY = {"code": "f00d", "inputs": {"a": 0.1, "n": 3, "box": (1.0, 2.0)}}
CONTENT = {"rows": {"k": {"U": [1e-3, None]}, "s": {"U": []}}, "seconds": 1.5}


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.setattr(records, "FOLDER", tmp_path)
    return tmp_path


def current(made_by=MADE_BY, subject="plate"):
    return RECORDS.current(subject, made_by, lambda record: record.content)


def test_a_record_reads_back_with_the_day_it_was_made(folder, monkeypatch):
    monkeypatch.setattr(time, "gmtime", lambda: time.struct_time((2026, 1, 2, 23, 59, 0, 4, 2, 0)))
    path = RECORDS.keep("plate", MADE_BY, CONTENT)
    assert path == folder / "made-up" / "plate.json"
    assert current() == CONTENT
    assert RECORDS.stored("plate").date == "2026-01-02"
    assert list(json.loads(path.read_text("utf-8"))) == [
        "checksum", "kind", "subject", "date", "made by", "content",
    ]  # fmt: skip


@pytest.mark.parametrize(
    "other",
    [
        {"code": "f00e", "inputs": MADE_BY["inputs"]},
        {"code": "f00d", "inputs": MADE_BY["inputs"] | {"a": 0.1 + 1e-16}},
        {"code": "f00d", "inputs": MADE_BY["inputs"] | {"b": 0.0}},
        {"code": "f00d"},
    ],
    ids=["code", "one digit", "one input more", "no inputs"],
)
def test_what_something_else_made_is_stored_and_not_current(other):
    RECORDS.keep("plate", MADE_BY, CONTENT)
    assert current(other) is None
    assert RECORDS.stored("plate").content == CONTENT


def test_an_edited_content_is_no_record():
    path = RECORDS.keep("plate", MADE_BY, CONTENT)
    text = path.read_text("utf-8")
    for value in ("1.4", "9" * 400, '"1.5"', "[[1.5]]"):
        path.write_text(text.replace('"seconds": 1.5', f'"seconds": {value}'), "utf-8")
        assert current() is None
    today = records.today()
    for old, new in ((today, "2031-01-01"), ("f00d", "f00e"), ('"kind"', '"more": 1, "kind"')):
        path.write_text(text.replace(old, new), "utf-8")
        assert RECORDS.stored("plate") is None
    path.write_text(json.dumps(json.loads(text)), "utf-8")  # another layout
    assert current() == CONTENT


@pytest.mark.parametrize(
    "text", ["", "{", "7", '{"made by": 1}', "\xff", "[" * 100_000], ids=lambda t: t[:9]
)
def test_a_torn_file_is_no_record(text):
    path = RECORDS.keep("plate", MADE_BY, CONTENT)
    whole = json.loads(path.read_text("utf-8"))
    path.write_bytes(text.encode("latin-1"))
    assert RECORDS.stored("plate") is None
    assert current() is None
    for wrong in ({"kind": "other"}, {"subject": "ring"}, {"date": 3}, {"date": "2026-13-01"}):
        path.write_text(json.dumps(whole | wrong), "utf-8")
        assert RECORDS.stored("plate") is None


def test_numbers_that_json_lacks_and_a_folder_that_cannot_be_written_are_refused(folder):
    with pytest.raises(ValueError, match="not JSON compliant"):
        RECORDS.keep("plate", MADE_BY, {"k": float("nan")})
    assert not list(folder.iterdir())
    (folder / "made-up").write_text("a file", "utf-8")
    with pytest.raises(OSError, match=r"made-up/plate.json: cannot be written: .+"):
        RECORDS.keep("plate", MADE_BY, CONTENT)
