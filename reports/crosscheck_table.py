"""All comparisons with second solvers as a table for other programs."""

import csv
import io
from collections.abc import Sequence
from dataclasses import fields

from reports.rows import harmless
from verify.core.results import Crosscheck

LEFT_OUT = ("seconds",)


def crosscheck_csv(checks: Sequence[Crosscheck]) -> str:
    """One line each, as rows.csv is written; differences are relative.

    Seconds are the project's and the other solver's.
    """
    names = [f.name for f in fields(Crosscheck) if f.name not in LEFT_OUT]
    file = io.StringIO()
    table = csv.writer(file, lineterminator="\n")
    table.writerow([*names, "seconds_here", "seconds_there"])
    for check in checks:
        own = [getattr(check, name) for name in names]
        table.writerow(map(harmless, (*own, *(check.seconds or ("", "")))))
    return "\ufeff" + file.getvalue()
