"""Check of a parameter file from Python: verdict, margin and every limit of a roller freewheel.

The commands `freewheel init freewheel-clutch > clutch.toml` and `freewheel check clutch.toml` give
the same answer.
"""

import tempfile
from math import isfinite
from pathlib import Path

import matplotlib.pyplot as plt

from verify.answers.parameter_file import read
from verify.answers.registry import answer
from verify.answers.template import template
from verify.cases.registry import find

with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "clutch.toml"
    path.write_text(template(find("freewheel-clutch")), "utf-8")
    file = read(path)
part = answer(file.case, file.inputs, file.values)
print(f"{file.name}: {part.verdict}")
print(f"margin {part.limiting.margin:.2f}, limited by {part.limiting.what}")

margins = {c.what: c.margin for c in part.criteria if isfinite(c.margin)}
plt.figure(figsize=(7, 2.5))
plt.barh([*margins], [*margins.values()])
plt.axvline(1.0, color="C3")
plt.xlabel("margin (the part holds if all are at least 1)")
plt.savefig("check_of_a_parameter_file.png", dpi=110, bbox_inches="tight")
