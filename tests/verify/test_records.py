"""Records of measurements: valid for the code that made them, complete or absent, readable."""

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


def test_what_something_else_made_is_stored_and_not_current():
    RECORDS.keep("plate", MADE_BY, CONTENT)
    for other in (
        MADE_BY | {"code": "f00e"},
        MADE_BY | {"inputs": MADE_BY["inputs"] | {"a": 0.1 + 1e-16}},
        {"code": "f00d"},
    ):
        assert current(other) is None, other
    assert RECORDS.stored("plate").content == CONTENT


def test_an_edited_or_torn_file_is_no_record():
    path = RECORDS.keep("plate", MADE_BY, CONTENT)
    text = path.read_text("utf-8")
    seconds = '"seconds": 1.5'
    for old, new in (
        (seconds, '"seconds": 1.4'), (seconds, f'"seconds": {"9" * 400}'),
        (records.today(), "2031-01-01"), ("f00d", "f00e"), ('"kind"', '"more": 1, "kind"'),
        (text, ""), (text, "{"), (text, "7"), (text, "[" * 100_000),
    ):  # fmt: skip
        path.write_text(text.replace(old, new), "utf-8")
        assert RECORDS.stored("plate") is None, new[:20]
        assert current() is None
    for content in (b"\xff", RECORDS.keep("ring", MADE_BY, CONTENT).read_bytes()):
        path.write_bytes(content)
        assert RECORDS.stored("plate") is None
    path.write_text(json.dumps(json.loads(text)), "utf-8")  # another layout
    assert current() == CONTENT


def test_numbers_that_json_lacks_and_a_folder_that_cannot_be_written_are_refused(folder):
    with pytest.raises(ValueError, match="not JSON compliant"):
        RECORDS.keep("plate", MADE_BY, {"k": float("nan")})
    assert not list(folder.iterdir())
    (folder / "made-up").write_text("a file", "utf-8")
    with pytest.raises(OSError, match=r"made-up/plate.json: cannot be written: .+"):
        RECORDS.keep("plate", MADE_BY, CONTENT)
