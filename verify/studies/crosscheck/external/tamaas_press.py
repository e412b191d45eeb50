"""Script that runs tamaas on a gap from a file, in a separate Python environment.

python tamaas_press.py ASKED.json ANSWER.json
"""

import json
import sys
import time
from pathlib import Path
from typing import Any


def main(asked: Path, answer: Path) -> None:
    """Solve a contact; `asked` states gap (nx, ny), cell, E_star, load, tolerance and limit."""
    answer.write_text(json.dumps(press(json.loads(asked.read_text("utf-8")))), "utf-8")


def press(asked: Any) -> dict[str, Any]:
    """Pressure (nx, ny), solution time without imports [s], final solver error, tamaas version."""
    import numpy as np
    import tamaas

    tamaas.set_log_level(tamaas.LogLevel.error)
    gap, (hx, hy) = np.array(asked["gap"], float), asked["cell"]
    nx, ny = gap.shape
    surface = np.ascontiguousarray(-gap)
    start, cpu = time.perf_counter(), time.process_time()
    model = tamaas.ModelFactory.createModel(
        tamaas.model_type.basic_2d, [nx * hx, ny * hy], [nx, ny]
    )
    model.E, model.nu = asked["E_star"], 0.0
    tamaas.ModelFactory.registerNonPeriodic(model, "dcfft")
    solver = tamaas.PolonskyKeerRey(model, surface, asked["tolerance"])
    solver.setIntegralOperator("dcfft")  # without it the grid repeats, registered or not
    solver.max_iter = asked["limit"]
    error = solver.solve(asked["load"] / (nx * hx * ny * hy))
    seconds, cpu = time.perf_counter() - start, time.process_time() - cpu
    return {
        "pressure": np.array(model.traction).tolist(), "seconds": seconds, "cpu": cpu,
        "error": float(error), "version": tamaas.__version__,
    }  # fmt: skip


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
