"""tamaas on a gap from a file, in a Python of its own that has numpy and tamaas alone.

python tamaas_half_space.py ASKED.npz ANSWER.npz
"""

import sys
import time

import numpy as np
import tamaas


def main() -> None:
    asked = np.load(sys.argv[1])
    tamaas.set_log_level(tamaas.LogLevel.error)
    gap, (hx, hy) = asked["gap"], asked["cell"]
    nx, ny = gap.shape
    surface = np.ascontiguousarray(-gap)
    start, cpu = time.perf_counter(), time.process_time()
    model = tamaas.ModelFactory.createModel(
        tamaas.model_type.basic_2d, [nx * hx, ny * hy], [nx, ny]
    )
    model.E, model.nu = float(asked["E_star"]), 0.0
    tamaas.ModelFactory.registerNonPeriodic(model, "dcfft")
    solver = tamaas.PolonskyKeerRey(model, surface, float(asked["tolerance"]))
    solver.setIntegralOperator("dcfft")  # without it the grid repeats, registered or not
    solver.max_iter = int(asked["limit"])
    error = solver.solve(float(asked["load"]) / (nx * hx * ny * hy))
    seconds, cpu = time.perf_counter() - start, time.process_time() - cpu
    np.savez(
        sys.argv[2], pressure=np.array(model.traction), seconds=seconds, cpu=cpu, error=error,
        version=tamaas.__version__,
    )  # fmt: skip


if __name__ == "__main__":
    main()
