"""Script that runs ROSS on a rotor from a file, in a separate Python environment.

python ross_rotor.py ASKED.json ANSWER.json
"""

import json
import sys
import time
from pathlib import Path
from typing import Any


def main(asked: Path, answer: Path) -> None:
    """Solve the problem in the file `asked`, which `verify.studies.crosscheck.rotors` wrote."""
    answer.write_text(json.dumps(solve(json.loads(asked.read_text("utf-8")))), "utf-8")


def solve(asked: Any) -> dict[str, Any]:
    """Frequencies [rad/s] at each speed, major semi-axes of the orbits [m], and solution time [s].

    The time excludes imports.
    """
    import ross

    start = time.perf_counter()
    rotor = built(ross, asked)
    found: dict[str, Any] = {
        "frequencies": [frequencies(rotor, w, asked["count"]) for w in asked["speeds"]],
    }
    if asked["unbalance"]:
        found["orbit"] = orbit(rotor, asked["unbalance"])
    return found | {"seconds": time.perf_counter() - start, "version": ross.__version__}


def built(ross: Any, asked: Any) -> Any:
    """ROSS model of one shaft or of several coaxial shafts at the same speed."""
    shafts, nodes = [], 0
    for k, pieces in enumerate(asked["shafts"]):
        elements = []
        for i, p in enumerate(pieces):
            steel = ross.Material(f"shaft{k}piece{i}", rho=p["rho"], E=p["E"], Poisson=p["nu"])
            own = ross.ShaftElement(p["length"], p["d_i"], p["d_o"], material=steel)
            # ROSS's formula for Hutchinson's coefficient lacks a square: 0.712 instead of 0.925
            own.kappa = p["kappa"]
            own.phi = 12 * p["E"] * own.Ie / (steel.G_s * own.kappa * own.A * own.L**2)
            elements.append(own)
        shafts.append(elements)
        nodes += len(elements) + 1
    discs = [ross.DiskElement(n=n, m=m, Id=d, Ip=p) for n, m, d, p in asked["discs"]]
    bearings = [ross.BearingElement(**bearing) for bearing in asked["bearings"]]
    if len(shafts) > 1:
        return ross.CoAxialRotor(shafts, discs, bearings)
    return ross.Rotor(shafts[0], discs, bearings)


def frequencies(rotor: Any, speed: float, count: int) -> list[float]:
    """The lowest `count` damped frequencies [rad/s], forward and backward."""
    import numpy as np

    found = rotor.run_modal(speed, num_modes=4 * count + 8, sparse=False)
    return [float(w) for w in np.sort(found.wd[found.wd > 0])[:count]]


def orbit(rotor: Any, unbalance: Any) -> list[float]:
    """Major semi-axis [m] of the orbit at the probe, for each speed."""
    import numpy as np

    speeds = np.array(unbalance["speeds"], float)
    found = rotor.run_unbalance_response(
        unbalance["nodes"], unbalance["magnitudes"], unbalance["phases"], frequency=speeds
    )
    first = rotor.number_dof * unbalance["probe"]
    x, y = found.forced_resp[first : first + 2]
    return [float(a) for a in (abs(x + 1j * y) + abs(x - 1j * y)) / 2]


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
