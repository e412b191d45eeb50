"""Figures of a rotor: Campbell diagram, modes, response, convergence."""

from collections.abc import Sequence

import numpy as np

from analytic.rotor.transfer_response import transfer_unbalance_response
from analytic.rotor.transfer_shapes import mode_lines
from verify.cases.rotor.system.advice import SENSE, criticals
from verify.cases.rotor.system.formulas import TransferRotor
from verify.cases.rotor.system.inputs import CRITICALS, RPM
from verify.cases.rotor.system.sketch import outlines
from verify.core.case import Context
from verify.core.figures import Campbell, Curves, Figure, Mode, Refinement, Whirl
from verify.form.plots import line, plot

Hz, mm, um = 2 * np.pi, 1e-3, 1e-6
SPEEDS = 400  # number of speeds of the response
DRAWN = 4  # number of critical speeds with an animated mode


def figures(context: Context) -> Sequence[Figure]:
    q = context.inputs
    found: list[Figure] = [_campbell(q)]
    if criticals(q):
        found.append(_modes(q))
    if any(q.unbalanced()):  # on a rotating shaft
        found.append(_response(q))
    return (*found, *(_refinement(context) if context.converging else ()))


def _campbell(q: TransferRotor) -> Campbell:
    speeds, w, whirl = q.campbell
    top = 1.05 * float(w[np.isfinite(w)].max()) / Hz
    lines = tuple(
        (f"unbalance of shaft {' and '.join(e.shafts)}", abs(e.ratio) * RPM / Hz)
        for e in q.study.excited
    )
    ratio = {" and ".join(e.shafts): abs(e.ratio) for e in q.study.excited}
    met = tuple(
        (c.speed / RPM, c.speed * ratio[c.shafts] / Hz, f"{c.speed / RPM:.0f}")
        for c in criticals(q)
        if c.speed <= speeds[-1] and c.speed * ratio[c.shafts] / Hz <= top
    )
    return Campbell(
        title="Natural frequencies over the speed", x_label="n [r/min]", y_label="f [Hz]",
        speeds=speeds / RPM, frequencies=w / Hz, whirl=whirl, excitations=lines, critical=met,
        range=(q.speed_from / RPM, q.speed_to / RPM), y_top=top,
        note=f"Computed by transfer matrices, without damping. {_sense(q)}",
    )  # fmt: skip


def _sense(q: TransferRotor) -> str:
    if q.rotor.isotropic:
        return (
            "An unbalance excites whirl at the speeds where its line crosses the curve of a mode "
            "with the same sense of whirl."
        )
    return (
        "The bearings differ in x and y: orbits are elliptical, and unbalance excites each mode. "
        f"The sense of whirl is that at {q.speed / RPM:.5g} r/min."
    )


def _modes(q: TransferRotor) -> Whirl:
    ranked = sorted(
        ((float(e.speeds[k]), k, e) for e in q.study.excited for k in range(len(e.speeds))),
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
        names=tuple(shaft.name for shaft in q.shafts),
    )  # fmt: skip


def _response(q: TransferRotor) -> Curves:
    speeds = np.linspace(0.02, 1.0, SPEEDS) * q.speed_axis
    curves = []
    for k, (ratio, group) in enumerate(q.unbalanced().items()):
        if ratio:
            names = " and ".join(s.name for s in q.shafts if s.ratio == ratio)
            found = transfer_unbalance_response(q.rotor, speeds, group, excitation=ratio)
            y = found.amplitude(q.probe - 1) / um
            curves.append(line(f"unbalance of shaft {names}", speeds / RPM, y, k))
    return plot(f"Amplitude of node {q.probe} over the speed", "n [r/min]", "|r| [µm]", curves,
                y_log=True, note="The amplitude is the semi-major axis of the orbit.")  # fmt: skip


def _refinement(context: Context) -> Sequence[Figure]:
    exact = [q for q in TransferRotor.quantities() if q.name.startswith("frequency_")][:CRITICALS]
    keys = [q.name for q in exact if q.name in context.analytic]
    cells = np.array([1 / result.h for result in context.fem])
    errors = tuple(
        (
            key.replace("_", " "),
            np.array([abs(r.values[key] / context.analytic[key] - 1) for r in context.fem]),
        )
        for key in keys
    )
    return (
        Refinement(
            title="Error of beam elements against transfer matrices",
            x_label="elements per segment", y_label="|error|", cells=cells, errors=errors, order=2,
            note="The curves are the errors of natural frequencies at speed n.",
        ),
    )  # fmt: skip
