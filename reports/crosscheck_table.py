"""Table (CSV) of all comparisons with second solvers, for other programs."""

import csv
import io
from collections.abc import Sequence
from dataclasses import fields

from reports.rows import harmless
from verify.core.results import Crosscheck

LEFT_OUT = ("seconds",)


def crosscheck_csv(checks: Sequence[Crosscheck]) -> str:
    """CSV text with one line for each comparison; differences are relative.

    The two times are those of the project and of the second solver [s].
    """
    names = [f.name for f in fields(Crosscheck) if f.name not in LEFT_OUT]
    file = io.StringIO()
    table = csv.writer(file, lineterminator="\n")
    table.writerow([*names, "seconds_here", "seconds_there"])
    for check in checks:
        own = [getattr(check, name) for name in names]
        table.writerow(map(harmless, (*own, *(check.seconds or ("", "")))))
    return "\ufeff" + file.getvalue()
