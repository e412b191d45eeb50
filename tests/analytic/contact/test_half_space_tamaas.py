"""The half-space beside tamaas, a solver of others, on the same grids."""

from types import ModuleType
from typing import Any

import numpy as np
import pytest

from analytic.contact import love
from analytic.contact.half_space import press
from analytic.contact.half_space_contact import centres
from verify.studies.crosscheck.external.tamaas_press import press as press_there

E_STAR = 1.1319e11  # Pa
NEAR = 1e-5  # relative difference of pressures in the mean square


@pytest.fixture
def tamaas() -> ModuleType:
    module = pytest.importorskip("tamaas", reason="tamaas is not installed")
    module.set_log_level(module.LogLevel.warning)
    return module


def model(tamaas: ModuleType, shape: tuple[int, int], cell: tuple[float, float]) -> Any:
    """Two half-spaces of modulus E* together whose grid does not repeat.

    Registering the padded operator is not all: the solver repeats the grid unless a flag is set.
    """
    sides = [n * h for n, h in zip(shape, cell, strict=True)]
    found = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, sides, list(shape))
    found.E, found.nu = E_STAR, 0.0
    tamaas.ModelFactory.registerNonPeriodic(found, "dcfft")
    return found


def pressed(gap: np.ndarray, cell: tuple[float, float], load: float) -> np.ndarray:
    """Pressure (nx, ny) by tamaas."""
    asked = {"gap": gap, "cell": cell, "E_star": E_STAR, "load": load, "tolerance": 1e-12,
             "limit": 20_000}  # fmt: skip
    return np.array(press_there(asked)["pressure"])


def test_tamaas_takes_loves_influence_between_cell_centres(tamaas: ModuleType) -> None:
    shape, cell = (12, 20), (2e-6, 7e-6)
    there, load, found = model(tamaas, shape, cell), np.zeros(shape), np.zeros(shape)
    load[0, 0] = 1.0
    there.operators["dcfft"](load, found)
    table = love.table(shape, cell=cell, E_star=E_STAR)
    assert found == pytest.approx(table, rel=1e-11, abs=0)


def test_a_crowned_roller_has_the_same_pressures(tamaas: ModuleType) -> None:
    length, load, R = 9e-3, 3400.0, 2.9519e-3
    cell = (9.1e-6, length / 128)
    unit, y = load / (np.pi * length * E_STAR), centres(128, length / 128)
    t = np.maximum(0.0, (np.abs(y) - length / 2) / (0.35 * length) + 1)
    crown = -unit * np.log(1 - (1 - np.exp(-1e-5 / unit)) * t**2)
    gap = centres(32, cell[0])[:, None] ** 2 / (2 * R) + crown + 1e-4 * y  # tilted a little
    ours = press(gap, cell=cell, E_star=E_STAR, load=load).pressure
    theirs = pressed(gap, cell, load)
    assert np.linalg.norm(ours - theirs) < NEAR * np.linalg.norm(theirs)
