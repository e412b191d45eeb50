"""Data that all pages of a server share."""

from dataclasses import dataclass
from pathlib import Path

from verify.app.page.folder import Folder
from verify.app.page.jobs import Jobs, Worker
from verify.app.page.parts import PARTS

FIRST = next(iter(PARTS.values()))  # the case of a page without a link and a file


@dataclass(frozen=True)
class Place:
    """The folder, the processes for answers, the jobs, and a folder for reports."""

    folder: Folder
    reports: Path
    formulas: Worker
    details: Worker
    jobs: Jobs
    first: str = ""  # parameter file that a page without a link shows
