"""What the report shows of a rotor: sketch, Campbell diagram, modes, response, convergence."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.rotor.transfer_response import unbalance_response
from analytic.rotor.transfer_shapes import mode_lines
from verify.case import Context, Values
from verify.cases.rotor_system_claims import frequency_keys
from verify.cases.rotor_system_inputs import RPM, SystemInputs
from verify.cases.rotor_system_model import CRITICALS, campbell, study
from verify.cases.rotor_system_words import SENSE, criticals
from verify.shown import (
    Campbell,
    Curve,
    Curves,
    Equation,
    Figure,
    Mode,
    Refinement,
    Shape,
    Sketch,
    Whirl,
)
from verify.tex import tex

Hz, mm, um = 2 * np.pi, 1e-3, 1e-6
SPEEDS = 400  # of the response
DRAWN = 4  # critical speeds in motion


def outlines(q: SystemInputs) -> list[tuple[Any, Any]]:
    """Places and radii (m,) [m] of each shaft, a step as two points of one place."""
    found = []
    for shaft in q.shafts:
        z, r, at = [], [], shaft.start
        for s in (s for s in q.segments if s.shaft == shaft.name):
            z += [at, at + s.length]
            r += [s.d_o / 2] * 2
            at += s.length
        found.append((np.array(z), np.array(r)))
    return found


def sketch(q: SystemInputs) -> Sketch:
    """Half a section above the axis; discs as upright lines, bearings below."""
    lines = outlines(q)
    length = max(z.max() for z, _ in lines)
    tall = length / 6  # radii are drawn larger than lengths
    k = tall / max(r.max() for _, r in lines)
    shapes = [
        Shape(style="axis", points=np.array([[-0.05 * length, 0.0], [1.05 * length, 0.0]])),
    ]
    for (z, r), shaft in zip(lines, q.shafts, strict=True):
        bore = [s.d_i / 2 for s in q.segments if s.shaft == shaft.name for _ in range(2)]
        points = np.vstack([
            np.column_stack([z, k * r]), np.column_stack([z, k * np.array(bore)])[::-1],
        ])  # fmt: skip
        shapes.append(Shape(style="body", points=points))
    shaft_of = q.rotor.shaft_of
    for disc in q.discs:
        z = q.places[disc.node - 1]
        foot = k * float(np.interp(z, *lines[shaft_of[disc.node - 1]]))
        top = 1.45 * tall
        line = np.array([[z, foot], [z, top]])
        shapes.append(Shape(style="line", points=line, label=str(disc.node)))
    for support in q.supports:
        z, a = q.places[support.node - 1], 0.03 * length
        wedge = np.array([[z, 0.0], [z - a, -1.7 * a], [z + a, -1.7 * a]])
        shapes.append(Shape(style="body", points=wedge))
        shapes.append(Shape(style="text", points=wedge[1:2] - [0, a], label=str(support.node)))
    names = ", ".join(s.name for s in q.shafts)
    title = f"shafts {names}, radii drawn larger; nodes of discs above, of bearings below"
    return Sketch(title=title, shapes=tuple(shapes))


def equations(q: SystemInputs, v: Values) -> Sequence[Equation]:
    first = rf"= {tex(v['frequency 1'], 5)}\ \mathrm{{Hz}}"
    return (
        Equation(
            tex=r"\frac{d}{dz}\begin{pmatrix} r\\ \varphi\\ Q\\ M\end{pmatrix} = "
            r"\begin{pmatrix} 0&1&\frac{1}{\kappa GA}&0\\ 0&0&0&\frac{1}{EI}\\ "
            r"-\rho A\omega^2&0&0&0\\ 0&-\rho I(\omega^2-2\Omega\omega)&-1&0\end{pmatrix}"
            r"\begin{pmatrix} r\\ \varphi\\ Q\\ M\end{pmatrix}",
            place="turning Timoshenko shaft",
        ),
        Equation(
            tex=r"\det D(\omega_1, \Omega) = 0,\quad \omega_1/2\pi",
            numbers=rf"{first}\quad(\Omega = {tex(q.speed / RPM)}\ \mathrm{{r/min}})",
            place="none missed: the negative eigenvalues of D count the roots below ω",
        ),
    )


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    found: list[Figure] = [_campbell(q)]
    if criticals(q):
        found.append(_modes(q))
    if any(q.unbalanced()):  # on a shaft that turns
        found.append(_response(q))
    return (*found, *(_refinement(context) if context.converging else ()))


def _campbell(q: SystemInputs) -> Campbell:
    speeds, w, whirl = campbell(q)
    top = 1.05 * float(w[np.isfinite(w)].max()) / Hz
    lines = tuple(
        (f"unbalance of {' and '.join(e.shafts)}", abs(e.ratio) * RPM / Hz)
        for e in study(q).excited
    )
    ratio = {" and ".join(e.shafts): abs(e.ratio) for e in study(q).excited}
    met = tuple(
        (c.speed / RPM, c.speed * ratio[c.shafts] / Hz, f"{c.speed / RPM:.4g}")
        for c in criticals(q)
        if c.speed <= speeds[-1] and c.speed * ratio[c.shafts] / Hz <= top
    )
    return Campbell(
        title="Natural frequencies over the speed", x_label="n [r/min]", y_label="f [Hz]",
        speeds=speeds / RPM, frequencies=w / Hz, whirl=whirl, excitations=lines, critical=met,
        range=(q.speed_from / RPM, q.speed_to / RPM), y_top=top,
        note="By transfer matrices, damping left out. Unbalance meets whirl of its own sense where "
        "its line crosses a branch.",
    )  # fmt: skip


def _modes(q: SystemInputs) -> Whirl:
    ranked = sorted(
        ((float(e.speeds[k]), k, e) for e in study(q).excited for k in range(len(e.speeds))),
        key=lambda item: item[0],
    )[:DRAWN]  # fmt: skip
    modes = []
    for speed, k, excited in ranked:
        lines = mode_lines(excited.modes, k, points=5)
        modes.append(
            Mode(
                name=f"{speed / RPM:.5g} r/min, {SENSE[int(excited.modes.whirl[k])]}",
                lines=tuple(
                    ((shaft.start + line.z) / mm, line.plus + line.minus,
                     (line.plus - line.minus) / 1j)
                    for shaft, line in zip(q.shafts, lines, strict=True)
                ),
            )
        )  # fmt: skip
    return Whirl(
        title="Modes at the lowest critical speeds", unit="mm", modes=tuple(modes),
        outlines=tuple((z / mm, r / mm) for z, r in outlines(q)),
        supports=tuple(q.places[s.node - 1] / mm for s in q.supports),
        links=tuple(q.places[s.node - 1] / mm for s in q.links),
    )  # fmt: skip


def _response(q: SystemInputs) -> Curves:
    speeds = np.linspace(0.02, 1.0, SPEEDS) * 1.2 * max(q.speed_to, q.speed)
    curves = []
    for k, (ratio, group) in enumerate(q.unbalanced().items()):
        if ratio:
            names = " and ".join(s.name for s in q.shafts if s.ratio == ratio)
            found = unbalance_response(q.rotor, speeds, group, excitation=ratio)
            y = found.amplitude(q.probe - 1) / um
            curves.append(Curve(name=f"unbalance of {names}", x=speeds / RPM, y=y, colour=k))
    return Curves(
        title=f"Amplitude of node {q.probe} over the speed", x_label="n [r/min]",
        y_label="|r| [µm]", curves=tuple(curves), y_log=True,
        note="Half the large axis of the orbit.",
    )  # fmt: skip


def _refinement(context: Context) -> Sequence[Figure]:
    keys = [k for k in frequency_keys(context) if k.startswith("frequency")][:CRITICALS]
    cells = np.array([1 / result.h for result in context.fem])
    errors = tuple(
        (f"{key}", np.array([abs(r.values[key] / context.analytic[key] - 1) for r in context.fem]))
        for key in keys
    )
    return (
        Refinement(
            title="Beams against transfer matrices", x_label="elements a segment",
            y_label="|error|", cells=cells, errors=errors, order=2,
            note="Natural frequencies at the speed.",
        ),
    )  # fmt: skip
