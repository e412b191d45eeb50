"""Run time of an engagement of a sprag clutch: compiled Runge-Kutta steps and scipy's LSODA.

    python -m benchmarks.engagement

Both integrate the same clutch (Table 1 of Huang et al., contacts by Palmgren's law) over 60 ms
under a step of torque. The largest force is compared with that of both methods at their finest
settings. The times exclude compilation and the computation of the initial state.
"""

import time
from collections.abc import Callable
from typing import Any

import numpy as np

from analytic.sprag.closure import wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.events import engage_by_events
from analytic.sprag.geometry import LogSprag
from analytic.sprag.motion import Motion, Torque
from analytic.sprag.parts import SpragClutchParts
from analytic.sprag.table import tabulated
from analytic.sprag.transient import engage

TORQUE, DURATION, N_END = 25.0, 0.06, 12e3
STEPS = (4e-5, 2e-5, 1e-5, 5e-6, 2.5e-6)
TOLERANCES = (1e-4, 1e-5, 1e-6, 1e-7, 1e-9)
REPEATS = 5
MANY = 125  # number of engagements of a full factorial of three parameters at five levels


def main() -> None:
    parts = SpragClutchParts(
        sprag=LogSprag.from_wedge_angle(
            R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3, nu_0=np.radians(3.15)
        ),
        n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3,
    )  # fmt: skip
    clutch = SpragClutch(sprag=parts.sprag, n_s=12, compliance=parts.palmgren())
    motion = Motion(
        m_g=1.8e-3, I_g=1.18e-8, I_bi=1.41e-3, I_be=1.41e-3, K_r=0.01, alpha_max=0.5, C_rl=0.1,
        k_out=1e5, mu_s=0.12, mu_c=0.08, gamma_b=1.0,
    )  # fmt: skip
    states = wedged(clutch, N_END * np.linspace(0, 1, 400) ** 2)
    table, torque = tabulated(clutch, N_end=N_END), Torque.step(TORQUE)

    def steps(dt: float) -> Any:
        return engage(table, motion, torque, duration=DURATION, dt=dt)

    def events(rtol: float) -> Any:
        return engage_by_events(states, 12, motion, torque, duration=DURATION, rtol=rtol)

    steps(1e-5)
    finest, beside = steps(5e-7).N_max, events(1e-11).N_max
    print(f"{TORQUE:g} N m over {DURATION * 1e3:g} ms, one thread, median of {REPEATS}")
    print(f"at their finest both have N_max {finest:.4f} and {beside:.4f} N")
    found = {}
    for name, run, values in (("dt", steps, STEPS), ("rtol", events, TOLERANCES)):
        for value in values:
            seconds, N = timed(lambda run=run, value=value: run(value))
            found[name, value] = seconds
            print(f"  {name:4} {value:7g}: {seconds * 1e3:8.2f} ms, N_max off by "
                  f"{abs(N / finest - 1):.0e}")  # fmt: skip
    ratio = found["rtol", 1e-7] / found["dt", 1e-5]
    print(f"steps of 10 µs take {ratio:.0f} times less than LSODA with events at 1e-7")
    start = time.perf_counter()
    for _ in range(MANY):
        steps(1e-5)
    print(f"{MANY} engagements, tables made: {time.perf_counter() - start:.2f} s")


def timed(run: Callable[[], Any]) -> tuple[float, float]:
    """Median seconds of a run, and its largest force [N]."""
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        found = run()
        times.append(time.perf_counter() - start)
    return float(np.median(times)), float(found.N_max)


if __name__ == "__main__":
    main()
