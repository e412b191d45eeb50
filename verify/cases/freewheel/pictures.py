"""Pictures of loaded sectors of star and cup."""

from collections.abc import Iterator
from typing import Any

from verify.case import picture
from verify.core.figures import Picture


def around_roller(q: Any) -> tuple[float, float, float, float]:
    """Window (left, bottom, right, top) [m] around the roller."""
    x, y = (float(v) for v in q.cam.centre(d_i=0.0, d_o=0.0))
    w = 1.35 * q.r
    return x - w, y - w, x + w, y + w


def heaviest(q: Any) -> Iterator[Picture]:
    """Pictures of the von Mises stress in the pitch and around the roller."""
    yield picture("sector", "log_mises", displacement="",
                  caption="Von Mises stress in one pitch, at the largest computed normal force"
                  )  # fmt: skip
    yield picture(
        "sector", "log_mises", displacement="", window=around_roller(q),
        caption="Von Mises stress in the roller and around both contacts; stresses below 10 MPa "
                "have one colour",
    )  # fmt: skip


def pulled(displacement: str, shear: str, **window: Any) -> Iterator[Picture]:
    """Pictures of axial displacement and axial shear stress with the given captions."""
    yield Picture(field="sector", data="u_z", symbol="u_z", unit="µm", factor=1e-6,
                  displacement="", caption=displacement)  # fmt: skip
    yield Picture(field="sector", data="log_shear_z", symbol="τ_z", unit="MPa", factor=1.0,
                  decades=True, displacement="", caption=shear, **window)  # fmt: skip
