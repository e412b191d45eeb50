"""Half-spaces in contact: this project and tamaas on equal grids.

    python -m benchmarks.half_space

tamaas runs in a separate Python: that of TAMAAS_PYTHON, or the present one if it has tamaas. First
the results are compared. Then both solvers are timed alternately with THREADS (default 1) threads,
from the gap in memory to the pressures. The time includes the influence coefficients and their
transform, but not imports and files. Both results are judged by the same measure: the largest error
of the gap over the largest displacement, with equal influence coefficients. The error is the
remaining gap where pressure acts, and the overlap where no pressure acts. tamaas terminates by
another measure: pressure times gap, over load times roughness. This project terminates when its
error is not larger than that of tamaas. Plot and numbers are written to benchmarks/out.
"""

import json
import os
import platform
import subprocess
import sys
import time
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from scipy import fft

from analytic.contact.half_space import press_half_space
from analytic.contact.half_space_contact import centres
from analytic.contact.half_space_convolution import Convolution
from benchmarks.plot_half_space import draw
from verify.studies.crosscheck.external import tamaas_press

OUT = Path(__file__).parent / "out"
PEER = Path(tamaas_press.__file__)
THREADS = int(os.environ.get("THREADS", "1"))
TOLERANCE = 1e-10
FINEST = 1e-13  # limit of double precision
LIMIT = 5000  # iterations of tamaas
SHORT, RUNS, LONG = 5.0, 5, 3  # s; number of runs below and above this time
R, LENGTH, E_STAR, LOAD = 2.9519e-3, 9e-3, 1.1319e11, 3400.0  # equivalent roller of a sprag, SI
HALF_WIDTH = np.sqrt(4 * LOAD * R / (np.pi * E_STAR * LENGTH))
RADIUS, RIM = 1e-2, 1e-4  # radius of a sphere, and radius of its contact
Array = np.ndarray


@dataclass(frozen=True)
class Asked:
    """A contact on a grid."""

    kind: str
    gap: Array
    cell: tuple[float, float]
    load: float


def roller(nx: int, ny: int, tilt: float) -> Asked:
    """Roller with a logarithmic crown (K_1 = 1, K_2 = 0.7, z_m = 10 um) on 2.6 half-widths."""
    cell = 2.6 * HALF_WIDTH / nx, LENGTH / ny
    y, unit = centres(ny, cell[1]), LOAD / (np.pi * LENGTH * E_STAR)
    t = np.maximum(0.0, (np.abs(y) - LENGTH / 2) / (0.35 * LENGTH) + 1)
    crown = -unit * np.log(1 - (1 - np.exp(-1e-5 / unit)) * t**2)
    gap = centres(nx, cell[0])[:, None] ** 2 / (2 * R) + crown + tilt * y
    return Asked("tilted roller" if tilt else "crowned roller", gap, cell, LOAD)


def sphere(n: int) -> Asked:
    cell = (2.4 * RIM / n,) * 2
    x = centres(n, cell[0])
    gap = (x[:, None] ** 2 + x**2) / (2 * RADIUS)
    return Asked("sphere", gap, cell, 4 * E_STAR * RIM**3 / (3 * RADIUS))


GRIDS = ((64, 256), (128, 512), (256, 1024))
ASKED = (
    *(roller(nx, ny, 0.0) for nx, ny in GRIDS),
    *(roller(nx, ny, 2e-4) for nx, ny in GRIDS),
    *(sphere(n) for n in (64, 128, 256)),
)


def tamaas_python() -> str | None:
    named = os.environ.get("TAMAAS_PYTHON")
    return named or (sys.executable if find_spec("tamaas") else None)


def ours(asked: Asked, tolerance: float = TOLERANCE) -> dict[str, Any]:
    start, cpu = time.perf_counter(), time.process_time()
    with fft.set_workers(THREADS):
        found = press_half_space(
            asked.gap, cell=asked.cell, E_star=E_STAR, load=asked.load, tolerance=tolerance
        )
    seconds, cpu = time.perf_counter() - start, time.process_time() - cpu
    return {
        "pressure": found.pressure, "seconds": seconds, "cpu": cpu, "iterations": found.iterations
    }  # fmt: skip


def theirs(asked: Asked, python: str) -> dict[str, Any]:
    with TemporaryDirectory() as folder:
        question, answer = Path(folder) / "asked.json", Path(folder) / "answer.json"
        question.write_text(json.dumps({
            "gap": asked.gap.tolist(), "cell": asked.cell, "load": asked.load, "E_star": E_STAR,
            "tolerance": TOLERANCE, "limit": LIMIT,
        }))  # fmt: skip
        subprocess.run(  # noqa: S603
            [python, str(PEER), str(question), str(answer)],
            env=os.environ | {"OMP_NUM_THREADS": str(THREADS)}, check=True,
        )  # fmt: skip
        found = json.loads(answer.read_text("utf-8"))
        return found | {"pressure": np.array(found["pressure"])}


def residual(asked: Asked, pressure: Array) -> float:
    """The largest error of the gap over the largest displacement, at the mean approach."""
    K = Convolution(asked.gap.shape, cell=asked.cell, E_star=E_STAR)  # type: ignore[arg-type]
    u = K.displacement(pressure)
    gap = u + asked.gap
    gap -= gap[pressure > 0].mean()
    return float(np.abs(np.where(pressure > 0, gap, np.minimum(gap, 0.0))).max() / u.max())


def compare(asked: Asked, python: str | None) -> dict[str, Any]:
    """Compare the results; then return medians of seconds of alternate runs."""
    nx, ny = asked.gap.shape
    row: dict[str, Any] = {"kind": asked.kind, "nx": nx, "ny": ny}
    if python is None:
        runs = [ours(asked) for _ in range(RUNS)]
        row["ours"] = median(run["seconds"] for run in runs)
        row["ours cpu"] = median(run["cpu"] for run in runs)
        row["residual"] = residual(asked, runs[0]["pressure"])
        print(f"{asked.kind}, {nx} x {ny} cells: {row['ours']:.4f} s, {row['residual']:.1e} left")
        return row
    yours = theirs(asked, python)
    row["their residual"] = residual(asked, yours["pressure"])
    row["error reported there"] = float(yours["error"])
    tolerance = max(min(TOLERANCE, row["their residual"]), FINEST)
    mine = ours(asked, tolerance)
    row["residual"] = residual(asked, mine["pressure"])
    row["iterations"] = mine["iterations"]
    apart = mine["pressure"] - yours["pressure"]
    row["difference"] = float(np.linalg.norm(apart) / np.linalg.norm(yours["pressure"]))
    runs = RUNS if yours["seconds"] < SHORT else LONG
    pairs = [(ours(asked, tolerance), theirs(asked, python)) for _ in range(runs)]
    row["ours"], row["tamaas"] = (median(float(p[i]["seconds"]) for p in pairs) for i in (0, 1))
    row["ours cpu"], row["tamaas cpu"] = (median(float(p[i]["cpu"]) for p in pairs) for i in (0, 1))
    row["ratios"] = sorted(float(b["seconds"] / a["seconds"]) for a, b in pairs)
    row["cpu ratios"] = sorted(float(b["cpu"] / a["cpu"]) for a, b in pairs)
    print(
        f"{asked.kind}, {nx} x {ny} cells, {row['iterations']} iterations here\n"
        f"    pressures differ by {row['difference']:.1e} in the mean square; residual "
        f"{row['residual']:.1e} here, {row['their residual']:.1e} there "
        f"(error reported there {row['error reported there']:.1e})\n"
        f"    median {row['ours']:.4f} s here, {row['tamaas']:.3f} s there; there / here, {runs} "
        f"runs in turn: {median(row['ratios']):.0f} ({row['ratios'][0]:.0f} to "
        f"{row['ratios'][-1]:.0f}), processor {median(row['cpu ratios']):.0f}",
        flush=True,
    )
    return row


def version(python: str) -> str:
    """The version of tamaas in that Python; ends the run if tamaas is not installed."""
    words = [python, "-c", "import tamaas; print(tamaas.__version__)"]
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=True)  # noqa: S603
    except (OSError, subprocess.CalledProcessError):
        print(f"TAMAAS_PYTHON must name a Python that has tamaas, got {python}", file=sys.stderr)
        raise SystemExit(2) from None
    return done.stdout.strip()


def main() -> None:
    OUT.mkdir(exist_ok=True)
    python = tamaas_python()
    name = "tamaas is not installed (TAMAAS_PYTHON names a Python that has it): ours alone"
    if python is not None:
        name = f"tamaas {version(python)}"
    print(f"Python {platform.python_version()}, {THREADS} thread(s) each; {name}", flush=True)
    rows = [compare(asked, python) for asked in ASKED]
    (OUT / "half_space.json").write_text(json.dumps({"peer": name, "rows": rows}, indent=1))
    draw(rows, OUT / "half_space.svg", OUT / "half_space.png")


if __name__ == "__main__":
    main()
