"""Durations of levels, from earlier runs or a cost model, and the remaining time of a run.

A level is named by its case and number; durations are wall-clock seconds of one process.
"""

import heapq
import json
import math
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from statistics import median

from verify.core.store import Store

Level = tuple[str, int]

COST_EXPONENT = 2.0  # plane meshes: cells grow with the square of the level
FINEST_SECONDS = 5.0  # expected time of a case's finest level without a measurement
OVERRUN = 0.5  # of the elapsed time: assumed rest of a level beyond its expected time
KIND = "duration"  # of entries
USUAL = Path(__file__).with_name("seconds.json")  # by case and level, on one machine


def expected_seconds(levels: Iterable[Level], known: Mapping[Level, float]) -> dict[Level, float]:
    """Expected duration [s] of each level.

    For a known level, it is the stored duration. For another level of the same case, it is scaled
    from the nearest known level by the cost model. For a case without known levels, the finest
    level has the median duration of the finest known levels of other cases.
    """
    levels = list(levels)
    finest: dict[str, int] = {}
    for case, level in known:
        finest[case] = max(level, finest.get(case, 0))
    usual = median(known[item] for item in finest.items()) if finest else FINEST_SECONDS
    top = {case: max(n for c, n in levels if c == case) for case, _ in levels}
    expected = {}
    for case, level in levels:
        near = [n for c, n in known if c == case] or [top[case]]
        anchor = min(near, key=lambda n: abs(math.log(max(n, 1) / max(level, 1))))
        cost = (max(level, 1) / max(anchor, 1)) ** COST_EXPONENT
        expected[case, level] = known.get((case, anchor), usual) * cost
    return expected


def refined(earlier: Mapping[Level, float], measured: Mapping[Level, float]) -> dict[Level, float]:
    """Durations measured in this run, and earlier durations scaled to the speed of this run."""
    both = [level for level in measured if level in earlier]
    before = sum(earlier[level] for level in both)
    pace = sum(measured[level] for level in both) / before if before else 1.0
    return {level: pace * seconds for level, seconds in earlier.items()} | dict(measured)


def remaining_seconds(
    running: Sequence[tuple[float, float]], waiting: Sequence[float], processes: int
) -> float:
    """Remaining time [s] until the end of the last level.

    `running` contains the expected and elapsed seconds of each running level. `waiting` contains
    the expected seconds of waiting levels, which start in this order as processes become free.
    """
    left = [e - t if e > t else OVERRUN * t for e, t in running]
    free = left + [0.0] * max(processes - len(left), 0)
    heapq.heapify(free)
    for seconds in waiting:
        heapq.heapreplace(free, free[0] + seconds)
    return max(free, default=0.0)


def usual() -> dict[Level, float]:
    """Durations [s] of levels, measured on another machine."""
    return {
        (case, int(level)): seconds
        for case, levels in json.loads(USUAL.read_text("utf-8")).items()
        for level, seconds in levels.items()
    }


def load(folder: Path) -> dict[Level, float]:
    """Durations stored in `folder`. Invalid entries are ignored."""
    found = {}
    with suppress(OSError):
        for name, content in Store(folder).all(KIND, KIND).items():
            case, _, level = name.rpartition(" ")
            with suppress(ValueError):
                seconds = float(content)
                if case and level.isdecimal() and 0 < seconds < math.inf:
                    found[case, int(level)] = seconds
    return found


def store(folder: Path, measured: Mapping[Level, float]) -> None:
    """Add `measured` to the stored durations. Raises OSError if the store cannot be written."""
    entries = {f"{case} {level}": f"{seconds:.4f}".encode()
               for (case, level), seconds in measured.items()}  # fmt: skip
    Store(folder).store(KIND, KIND, entries)
