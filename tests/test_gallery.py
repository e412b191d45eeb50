"""The gallery: every script runs, prints its key number next to the expected one, and draws."""

import re
import runpy
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
import pytest

SCRIPTS = Path(__file__).parents[1] / "examples" / "gallery"

# Line that a script prints, its numbers, and the relative tolerance: what the mesh leaves of it.
EXPECTED = {
    "campbell_diagram": ("forward critical speeds", [1660, 5827], 1e-3),
    "check_of_a_parameter_file": ("margin", [1.19], 1e-2),
    "contact_of_two_bodies": ("peak pressure", [1222.3, 1222.3], 5e-3),
    "hertz_line_contact": ("largest shear stress", [0.3003, 0.7862], 1e-3),
    "optimal_crown": ("largest pressure", [1.037], 2e-3),
    "partial_slip": ("stick zone", [0.5, 0.5], 1e-3),
    "plate_with_a_hole": ("stress concentration", [3, 3], 3e-3),
    "polyhedral_ring_under_pressure": ("growth above a flat", [14.806, 14.806], 1e-3),
    "press_fit": ("contact pressure", [21.679, 21.679], 1e-3),
    "roller_freewheel_under_torque": ("clamping angle without", [3.0212, 3.0212], 1e-4),
    "sprag_engagement": ("largest normal force", [6238, 1.840], 1e-3),
    "spring_curve": ("stiffness of the free stage", [1.900, 1.900], 1e-3),
    "sweep_of_a_formula": ("error at the thickest wall", [-0.40, -0.40], 1e-2),
    "templates_of_new_cases": ("frame: error of the rate", [1.37, 1.37], 1e-2),
    "thick_cylinder": ("hoop stress", [260, 260], 1e-3),
    "unbalance_response": ("largest amplitude", [125.66, 125.66], 2e-3),
}
NUMBER = re.compile(r"(?<![\w_])[+-]?\d+(?:\.\d+)?")


@pytest.fixture
def _drawn_to_files(monkeypatch, tmp_path):
    backend = mpl.get_backend()
    mpl.use("agg")
    monkeypatch.chdir(tmp_path)
    yield
    plt.close("all")
    mpl.use(backend)


@pytest.mark.usefixtures("_drawn_to_files")
@pytest.mark.parametrize("name", sorted(path.stem for path in SCRIPTS.glob("*.py")))
def test_a_script_prints_its_number_and_draws_its_picture(name, capsys):
    runpy.run_path(str(SCRIPTS / f"{name}.py"))
    start, expected, tolerance = EXPECTED[name]
    (line,) = (x for x in capsys.readouterr().out.splitlines() if x.startswith(start))
    found = [float(x) / (100 if f"{x}%" in line else 1) for x in NUMBER.findall(line)]
    assert found[: len(expected)] == pytest.approx(expected, rel=tolerance), line
    assert Path(f"{name}.png").stat().st_size > 5_000
