"""The page reads and writes only files of its folder."""

from pathlib import Path

import pytest

from verify.app.page.folder import Folder
from verify.core.inputs import InputError


@pytest.mark.parametrize("name", [
    "../out.toml", "a/../../out.toml", "/etc/passwd", "..\\out.toml", "C:\\x.toml", "", " ",
    ".hidden.toml", "a/.git/x.toml", "x" * 200 + ".toml", "a\nb.toml", "a//b.toml", "\0.toml",
])  # fmt: skip
def test_names_that_lead_out_of_the_folder_are_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(InputError):
        Folder(tmp_path).path(name, ".toml")


def test_a_link_out_of_the_folder_is_refused(tmp_path: Path) -> None:
    inside = tmp_path / "inside"
    inside.mkdir()
    (tmp_path / "secret.toml").write_text("x", "utf-8")
    (inside / "my.toml").symlink_to(tmp_path / "secret.toml")
    (inside / "up").symlink_to(tmp_path)
    for name in ("my.toml", "up/secret.toml"):
        with pytest.raises(InputError, match="by a link, to a file outside"):
            Folder(inside).path(name, ".toml")


def test_another_suffix_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"must end with \.toml"):
        Folder(tmp_path).path("my.sh", ".toml")


def test_a_file_is_written_and_not_overwritten_unless_asked(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    folder.write("my.toml", "a", ".toml")
    with pytest.raises(InputError, match="exists already"):
        folder.write("my.toml", "b", ".toml")
    folder.write("my.toml", "c", ".toml", replace=True)
    assert (tmp_path / "my.toml").read_text("utf-8") == "c"
    assert folder.names_of(".toml") == ["my.toml"]


def test_files_of_folders_below_are_listed_after_those_of_the_folder(tmp_path: Path) -> None:
    for name in ("b.toml", "a/x.toml", "a/b/y.toml", "c/z.toml", ".git/x.toml", "a/x.py"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("", "utf-8")
    (tmp_path / "again").symlink_to(tmp_path)
    folder = Folder(tmp_path)
    assert folder.names_of(".toml") == ["b.toml"]
    assert folder.names_of(".toml", below=True) == ["b.toml", "a/x.toml", "c/z.toml", "a/b/y.toml"]
    assert folder.names_of(".py") == []
    folder.write("c/new.toml", "", ".toml")
    assert "c/new.toml" in folder.names_of(".toml", below=True)
    with pytest.raises(InputError, match=r"^none/x\.toml: cannot be written: there is no folder"):
        folder.write("none/x.toml", "", ".toml")


def test_the_list_of_a_large_folder_ends(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("verify.app.page.folder.MOST_LOOKED", 10)
    for k in range(8):
        (tmp_path / f"{k}").mkdir()
        for n in range(3):
            (tmp_path / f"{k}" / f"{n}.toml").write_text("", "utf-8")
    assert len(Folder(tmp_path).names_of(".toml", below=True)) == 2


def test_no_folder_and_a_text_that_is_too_large_are_errors(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="is no folder"):
        Folder(tmp_path / "none")
    with pytest.raises(InputError, match="larger"):
        Folder(tmp_path).write("my.toml", "x" * 1_000_001, ".toml")
