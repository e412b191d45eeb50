"""Templates of new cases: error of each formula, computed on several meshes, and expected error.

`freewheel new-case FILE --kind KIND` writes one of these templates; docs/own_case.md explains them.
"""

from pathlib import Path

import matplotlib.pyplot as plt

import verify
from verify.app import templates

figure, axes = plt.subplots(2, 3, figsize=(10, 5.5), layout="constrained", sharex=True)
for file, ax in zip(sorted(Path(templates.__path__[0]).glob("[!_]*.py")), axes.flat, strict=True):
    row = next(row for row in verify.run(file).rows if row.interval)
    low, high = (100 * end for end in row.interval)
    errors = [100 * (row.analytic / value - 1) for _, value in row.levels]
    expected = f"expected {(low + high) / 2:.2f} %, {low:.2f} to {high:.2f} %"
    print(
        f"{file.stem}: error of the {row.quantity.partition(',')[0]} {errors[-1]:.2f} %, {expected}"
    )
    ax.axhspan(low, high, color="C2", alpha=0.3, label="expected error")
    ax.plot([1 / h for h, _ in row.levels], errors, "o-", label="against finite elements")
    ax.set(title=f"{file.stem.replace('_', '-')}: {row.quantity.partition(',')[0]}",
           ylabel="error [%]")  # fmt: skip
for ax in axes[1]:
    ax.set_xlabel("refinement")
axes[0, 0].legend(fontsize="small")
figure.savefig("templates_of_new_cases.png", dpi=110)
