"""Run time of many finite line contacts by coupled strips and by independent slices.

    python -m benchmarks.strips [cases]

Half of the rollers are tilted; loads are 500 to 6000 N. Strips are solved to 1e-8 of the load
(their pressures to 1e-7), slices to round-off. The strips are divided between all processors.
"""

import os
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from analytic.contact import lamina, strips
from analytic.contact.crown import logarithmic, slice_centres

SLICES, REPEATS = 50, 3
ROLLER = {"length": 9e-3, "R": 2.952e-3, "E_star": 113.2e9}
ALLOWED = {"coupled strips": 5.0, "independent slices": 0.5}  # s for 1e5 cases


def main() -> None:
    cases = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    workers = len(os.sched_getaffinity(0))
    roller = rollers(cases)
    runs: dict[str, Callable[[], Any]] = {
        "coupled strips": lambda: strips.press_strips(**roller, tolerance=1e-8, workers=workers),
        "independent slices": lambda: lamina.press_laminae(**roller),
    }
    print(f"{cases} rollers of {SLICES} slices, {workers} cores, median of {REPEATS}")
    for name, run in runs.items():
        times = []
        for _ in range(REPEATS):
            start = time.perf_counter()
            found = run()
            times.append(time.perf_counter() - start)
        load = found.q.sum(axis=-1) * 9e-3 / SLICES if name == "coupled strips" else found.load
        off = float(np.abs(load / roller["load"] - 1).max())
        print(
            f"{name:17} {np.median(times):6.2f} s (allowed for 1e5: {ALLOWED[name]:g} s), "
            f"{np.median(times) / cases * 1e6:5.1f} µs a case, loads met within {off:.0e}"
        )


def rollers(cases: int) -> dict[str, Any]:
    """Gaps (cases, SLICES), loads (cases,) and constant arguments."""
    rng = np.random.default_rng(1)
    y = slice_centres(length=9e-3, slices=SLICES)

    def some(low: float, high: float) -> Any:
        return rng.uniform(low, high, (cases, 1))

    gap = logarithmic(
        y, K_1=some(1, 5), K_2=some(0.4, 0.7), z_m=some(5e-6, 25e-6), load=3407.0, length=9e-3,
        E_star=113.2e9,
    )  # fmt: skip
    tilt = np.where(np.arange(cases)[:, None] % 2, some(0, 1e-3), 0.0)
    return {"gap": gap - tilt * y, "load": rng.uniform(500, 6000, cases), **ROLLER}


if __name__ == "__main__":
    main()
