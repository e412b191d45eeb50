"""A rotor of 132 unknowns here and in ROSS: Campbell diagram and unbalance response.

    python -m benchmarks.rotor          # in an environment that has ross-rotordynamics, too

Two shafts with 22 nodes, 50 speeds of the Campbell diagram with six frequencies each and 1000 of
the unbalance response, on isotropic and on unlike supports, damped and not. Matrices are assembled
before the clock starts; ours is the best of three, the other runs once. One thread.
"""

import time
from collections.abc import Callable

import numpy as np

from fem.rotor.campbell import campbell
from fem.rotor.response import unbalance_response
from tests.fem.rotor.rotor_ross import kappas, ours, theirs  # the same rotors as the tests

try:
    import ross
except ImportError:
    ross = None

SPEEDS = np.linspace(0, 4000, 50)
FINE = np.linspace(4, 4000, 1000)
UNBALANCES = {3: 1.4e-5, 18: 1e-5}


def main() -> None:
    if ross:  # its first run imports and compiles
        theirs(ross).run_campbell(SPEEDS[:2], frequencies=6)
    print(f"{'supports':<10} {'damped':<7} {'what':<28} {'here':>9} {'ROSS':>9} {'ratio':>7}")
    for unlike in (False, True):
        for damped in (False, True):
            supports = "unlike" if unlike else "isotropic"
            other = theirs(ross, unlike=unlike, damped=damped) if ross else None
            own = ours(kappas(other) if ross else [0.88] * 20, unlike=unlike, damped=damped)
            assert own.K.shape == (132, 132)
            pairs: list[tuple[str, Callable[[], object], Callable[[], object]]] = [
                (
                    "Campbell diagram, 50 speeds", lambda own=own: campbell(own, SPEEDS, 6),
                    lambda other=other: other.run_campbell(SPEEDS, frequencies=6),
                ),
                (
                    "unbalance, 1000 speeds",
                    lambda own=own: unbalance_response(own, FINE, UNBALANCES),
                    lambda other=other: other.run_unbalance_response(
                        list(UNBALANCES), list(UNBALANCES.values()), [0.0, 0.0], frequency=FINE
                    ),
                ),
            ]  # fmt: skip
            for what, mine, peer in pairs:
                here = min(seconds(mine) for _ in range(3))
                there = seconds(peer) if ross else np.nan
                print(
                    f"{supports:<10} {'yes' if damped else 'no':<7} {what:<28} "
                    f"{here:8.3f}s {there:8.2f}s {there / here:6.0f}x", flush=True,
                )  # fmt: skip


def seconds(run: Callable[[], object]) -> float:
    """Wall time of one run."""
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


if __name__ == "__main__":
    main()
