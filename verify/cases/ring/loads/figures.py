"""Figures and table of a race under n sprags: deflections, stresses, wind-up, peak force."""

from collections.abc import Iterator, Sequence

import numpy as np

from analytic.ring import windup
from verify.case import AlongLine, Drawn
from verify.cases.ring.loads.formulas import SpragLoads
from verify.cases.ring.loads.reference import wall_angles
from verify.core.case import Context
from verify.core.figures import Array, Curve, Curves, Picture, Table
from verify.form.fields import picture

MPa, um = 1e6, 1e-6
COUNTS = (6, 12, 24)
EDGE = 1.5  # formal order of the largest error, next to the patch
LISTED = (6, 8, 12, 16, 24)  # numbers of sprags in the table
DOTS = 40  # nodes of finite elements in a curve


def figures(self: SpragLoads) -> Iterator[AlongLine | Drawn]:
    """Figures: displacement and hoop stress over half a pitch."""
    yield Drawn(lambda context: (_ripple(self, context),))
    ring, pitch = self.race(), np.pi / self.n
    yield AlongLine(
        title=f"Displacement of the {self.loaded} by finite elements and Fourier series",
        x=("θ n/π", "1"), y=("δ", "µm"), points=np.linspace(0, 1, 200),
        curve=lambda x: self.outward * ring.at(ring.r, x * pitch).u_r, reference="displacement",
        at=wall_angles(self) / pitch, order=EDGE, scale=self.load,
        scale_name="the displacement under a sprag",
    )  # fmt: skip
    yield Drawn(lambda context: (_stresses(self, context),) if context.converging else ())


def around(q: SpragLoads) -> Array:
    """Angles over half a pitch, as fractions of half a pitch, (m,); dense near the patch."""
    alpha = q.half_width / q.radius * q.n / np.pi
    near = np.linspace(0, min(3 * alpha, 0.9), 40)
    return np.asarray(np.concatenate([near, np.linspace(near[-1], 1, 60)[1:]]))


def _ripple(q: SpragLoads, context: Context) -> Curves:
    shares, curves = around(q), []
    for k, n in enumerate(sorted({*COUNTS, q.n})):
        if not q.room_for(n):
            continue
        ring = q.race(n=n)
        u = q.outward * ring.at(ring.r, shares * np.pi / n).u_r
        curves.append(Curve(name=f"n = {n}", x=shares, y=u / q.by_smearing(n=n), colour=k))
        if n == q.n and context.fem:
            theta, u_r, _ = _thinned(context, q.loaded)
            curves.append(
                Curve(name=f"FE, n = {n}", x=theta * n / np.pi, style="dots", colour=k,
                      y=q.outward * u_r / q.smeared)
            )  # fmt: skip
    curves.append(
        Curve(name="Eq. 6", x=np.array([0.0, 1.0]), y=np.ones(2), style="dashes", colour=5)
    )
    return Curves(
        title=f"Displacement of the {q.loaded} around the race", y_bottom=None,
        x_label="θ n/π, from a sprag to the middle between two sprags",
        y_label="δ divided by Eq. 6",
        curves=tuple(curves),
        note="The force of a sprag is the same for all curves. δ is divided by the deflection by "
        "Eq. 6 at the n of the curve. The peak at the left is the local indentation. Eq. 6 gives "
        "the mean of each curve over θ exactly.",
    )  # fmt: skip


def _thinned(context: Context, wall: str) -> Array:
    """Angle, u_r and u_theta of some nodes of a wall on the finest mesh, shape (3, m)."""
    nodes = context.fem[-1].arrays[f"{wall} nodes"]
    n = context.inputs.n / np.pi
    wanted = np.linspace(0, 1, DOTS)
    chosen = np.unique(np.searchsorted(nodes[0] * n, wanted).clip(0, nodes.shape[1] - 1))
    return np.asarray(nodes[:, chosen])


def _stresses(q: SpragLoads, context: Context) -> Curves:
    """Figure of the hoop stress of both walls; of the loaded surface only outside the patch."""
    ring, fem = q.race(), context.fem[-1].arrays
    theta, at = around(q) * np.pi / q.n, wall_angles(q)
    curves = []
    for k, (name, r) in enumerate((("bore", q.r_i), ("rim", q.r_o))):
        drawn = theta[theta > ring.alpha] if name == q.loaded else theta
        hoop = ring.at(r, drawn).sigma_theta
        curves += [
            Curve(name=name, x=drawn * q.n / np.pi, y=hoop / MPa, colour=k),
            Curve(name=f"FE, {name}", x=at * q.n / np.pi, y=fem[f"{name} hoop stress"] / MPa,
                  style="dots", colour=k),
        ]  # fmt: skip
    return Curves(
        title="Hoop stress at bore and rim", x_label="θ n/π", y_label="σ_θ [MPa]",
        curves=tuple(curves), note=f"Lines: Fourier series. The curve of the {q.loaded} begins at "
        "the edge of the contact patch: in the patch, the hoop stress"
        " is compressive and about as large as the pressure.",
    )  # fmt: skip


def pictures(self: SpragLoads) -> Iterator[Picture]:
    """Pictures: radial displacement over a pitch, von Mises stress near a sprag."""
    view = 12 * self.half_width
    window = (self.radius - view, -view, self.radius + view, view)
    yield Picture(field="half a pitch", data="radial_displacement", symbol="u_r", unit="µm",
                  factor=um, caption="Radial displacement over a pitch", mirror=("y",))  # fmt: skip
    yield picture("half a pitch", "von_mises", "Von Mises stress near a sprag, element averages",
                  mirror="y", window=window)  # fmt: skip


def ratios(races: Sequence[SpragLoads], n: int) -> tuple[float, float]:
    """Ratios of wind-up and of peak force, both by Lamé and Hertz, to those of Fourier rings."""
    return windup.ratios([
        windup.compliances(q.race(n=n), R=q.R, F=q.F, L=q.L) for q in races
    ])  # fmt: skip


def table(q: SpragLoads, pair: Sequence[SpragLoads]) -> Table:
    """Table of errors of wind-up and peak force over n: this race and, with `pair`, both races."""
    rows: list[tuple[str | float | None, ...]] = []
    for n in sorted({*LISTED, q.n}):
        if not all(race.room_for(n) for race in (q, *pair)):
            continue
        both = ratios(pair, n) if pair else ()
        rows.append((str(n), *(f"{x - 1:+.1%}" for x in (*ratios((q,), n), *both))))
    header = ("n", "wind-up, this race", "peak force, this race")
    return Table(
        title="Lamé's ring with Hertz's indentation: errors of wind-up and peak force",
        header=(*header, "wind-up, both races", "peak force, both races") if pair else header,
        rows=tuple(rows),
        note=f"The reference is the Fourier series of the ring. The indentation is relative to a "
        "point one wall thickness deep. For the wind-up, each sprag carries "
        f"{q.F:.4g} N in both models. For the peak force of a shock, both models store the same "
        "energy: that of Lamé's ring with Hertz's indentation under this force. A model that is "
        "too compliant overestimates the wind-up (conservative) and "
        "underestimates the peak force (unsafe).",
    )
