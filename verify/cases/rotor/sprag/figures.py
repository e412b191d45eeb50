"""Figures of the system with sprag clutch: each figure covers all members of the ensemble."""

from collections.abc import Sequence
from math import pi
from typing import Any

import numpy as np

from analytic.rotor.transfer_modes import natural_frequencies
from verify.cases.rotor.sprag.check_types import Arrays, arrays
from verify.cases.rotor.sprag.formulas import ORDERS, rotor
from verify.cases.rotor.sprag.inputs import PRINTED, RPM
from verify.cases.rotor.sprag.layout import (
    BETWEEN,
    CENTRAL,
    CLUTCH,
    DISCS,
    GROUNDED,
    HIGH,
    LOW,
    OUTER,
    PARAMETERS,
    layout,
)
from verify.cases.rotor.sprag.response_fem import SHOWN_NODES, SMALL_OFFSETS
from verify.core.case import Context
from verify.core.figures import (
    Array,
    Band,
    Campbell,
    Curves,
    Figure,
    Mode,
    Panel,
    Parallel,
    ParallelAxis,
    Shapes,
    Whirl,
)
from verify.form.plots import line, plot

um, mm = 1e-6, 1e-3
PEERS = np.array([0, 10_000, 20_000, 30_000, 40_000]) * RPM
FORWARD, BACKWARD = 1, -1
TURN = np.exp(2j * pi * np.linspace(0, 1, 91))
BANDS = (
    "Each line is the median over the sets of parameters; its band extends from the 5th to the "
    "95th percentile."
)
CRITICAL = tuple((n / RPM, f"n_{k}") for k, n in zip(ORDERS, PRINTED, strict=True))


def figures(context: Context) -> Sequence[Figure]:
    if not context.fem or not arrays(context)["members"].size:
        return ()
    a = arrays(context)
    return (
        campbell(a), shapes(context, a), *responses(a), *over_unbalance(context, a), loads(a),
        torsion(context, a), *orbits(context, a), parallel(a),
    )  # fmt: skip


def campbell(a: Arrays) -> Campbell:
    peers = natural_frequencies(rotor(), PEERS, count=6) / (2 * pi)
    speeds = np.repeat(PEERS[:, None], 6, axis=1) / RPM
    return Campbell(
        title="Natural frequencies of the system fitted from mid-range parameters (Fig. 8)",
        x_label="n [r/min]",
        y_label="f [Hz]", speeds=a["swept"] / RPM, frequencies=a["branches"],
        whirl=tuple(int(w) for w in a["branches, whirl"]), excitations=(("1×", 1 / 60),),
        critical=tuple((n / RPM, n / (2 * pi), f"n_{k}")
                       for k, n in zip(ORDERS, PRINTED, strict=True)),
        peers=(speeds.ravel(), peers.ravel()), peers_name="transfer matrices",
        note="n_1, n_3 and n_5 are the printed critical speeds, to which the forward critical "
             "speeds were fitted.",
    )  # fmt: skip


def shapes(context: Context, a: Arrays) -> Whirl:
    s = layout(CENTRAL)
    z = s.z[0]
    modes = []
    for order, k in zip(ORDERS, np.flatnonzero(a["shapes, whirl"] == FORWARD), strict=False):
        both: Any = a["shapes"][k]
        lines = tuple(
            (z[own], both[own, 0], both[own, 1]) for own in (slice(OUTER), slice(OUTER, None))
        )
        modes.append(Mode(name=f"mode {order}, forward", lines=lines))
    return Whirl(
        title="Modes 1, 3 and 5 of the system fitted from mid-range parameters, at "
        f"{context.inputs.speed / RPM:.5g} r/min (Fig. 7)",
        unit="m", modes=tuple(modes), outlines=tuple(_outline(k) for k in range(2)),
        supports=tuple(float(z[n - 1]) for n in GROUNDED),
        links=tuple(float(z[a_ - 1]) for a_, _ in (*BETWEEN, CLUTCH)),
        names=("outer rotor", "inner rotor"),
    )  # fmt: skip


def _outline(k: int) -> tuple[Array, Array]:
    """Positions and radii along a rotor; two points at a step."""
    s = layout(CENTRAL)
    own = slice(OUTER - 1) if k == 0 else slice(OUTER - 1, None)
    nodes = slice(OUTER) if k == 0 else slice(OUTER, None)
    z = s.z[0, nodes]
    return np.repeat(z, 2)[1:-1], np.repeat(s.d_o[0, own] / 2, 2)


def responses(a: Arrays) -> tuple[Curves, ...]:
    over = a["nodes over speed"][:, 0] / um  # band, nodes, speeds
    found = []
    for name, own in (("outer", range(3)), ("inner", range(3, 6))):
        found.append(
            _banded(
                f"Unbalance response of the {name} rotor (Figs. 9 and 10)", "|x| [µm]", a,
                [(f"node {SHOWN_NODES[i]}", over[:, i]) for i in own],
            )
        )  # fmt: skip
    return tuple(found)


def loads(a: Arrays) -> Curves:
    over = a["bearings over speed"][:, 0]
    named = [(f"bearing {k + 3}", over[:, k]) for k in range(2)]
    return _banded("Loads of the bearings between the rotors (Fig. 12)", "F [N]", a, named)


def _banded(title: str, y_label: str, a: Arrays, named: list[tuple[str, Array]]) -> Curves:
    x = a["grid"] / RPM
    return plot(
        title, "n [r/min]", y_label, (line(n, x, v[1], i) for i, (n, v) in enumerate(named)),
        y_log=True, note=BANDS,
        bands=tuple(
            Band(name="", x=x, lower=v[0], upper=v[2], colour=i)
            for i, (_, v) in enumerate(named)
        ),
    )  # fmt: skip


def over_unbalance(context: Context, a: Arrays) -> tuple[Curves, ...]:
    """Figures of the median response of nodes 4 and 19 under three values of U_2 (Fig. 11)."""
    x = a["grid"] / RPM
    return tuple(
        plot(
            f"Response of node {SHOWN_NODES[i]} for three values of unbalance 2 (Fig. 11)",
            "n [r/min]",
            "|x| [µm]",
            (
                line(f"{U * 1e5:.3g}e-5 kg m", x, a["nodes over speed"][1, k, i] / um, k)
                for k, U in enumerate(context.inputs.unbalances_2)
            ),
            y_log=True, note="The lines are medians over the sets of parameters.",
        )
        for i in (SHOWN_NODES.index(node) for node in DISCS)
    )  # fmt: skip


def torsion(context: Context, a: Arrays) -> Curves:
    """Figure of the torsion of node 19 over the offset, scaled linearly from a small offset."""
    offsets = np.linspace(SMALL_OFFSETS[0], max(context.inputs.offset, SMALL_OFFSETS[-1]), 12)
    slopes = a["torsion, small offsets"][:, -1, :, DISCS[1] - 1] / SMALL_OFFSETS[-1] / um
    low, middle, high = np.percentile(slopes, (5, 50, 95), axis=0)
    return plot(
        "Torsional rotation of node 19 at bending critical speeds over the offset",
        "offset of the clutch Δx/δ_0",
        "|θ_z| [µrad]",
        (line(f"n_{k}", offsets, middle[i] * offsets, i) for i, k in enumerate(ORDERS)),
        bands=tuple(
            Band(name="", x=offsets, lower=low[i] * offsets, upper=high[i] * offsets, colour=i)
            for i in range(len(ORDERS))
        ),
        y_log=True, note=f"{BANDS} The rotation is proportional to the offset, and zero without "
                         "offset.",
    )  # fmt: skip


def orbits(context: Context, a: Arrays) -> tuple[Shapes, ...]:
    stiffer = (("isotropic", 1.0), ("anisotropic", 1 + context.inputs.anisotropy))
    return tuple(
        Shapes(
            title=f"Orbits of node {node} at {context.inputs.rig_speed / RPM:.5g} r/min (Fig. 15)",
            unit="µm",
            panels=tuple(
                _orbit(f"k_y = {times:.3g} k_x", a[f"orbit, {key}"][:, i]) for key, times in stiffer
            ),
            note="The strong line is the orbit of median size over the sets of parameters; the "
            "faint lines are the nine orbits nearest in size.",
        )
        for i, node in enumerate(DISCS)
    )


def _orbit(name: str, members: Any) -> Panel:
    """Orbit curves x, y (m, 2) of the members."""
    lines = [np.column_stack([(x * TURN).real, (y * TURN).real]) / um for x, y in members]
    size = np.abs(members).max(axis=1)
    middle = int(np.argsort(size)[size.size // 2])
    near = np.argsort(np.abs(np.log(size / size[middle])))[1:10]
    return Panel(name=name, lines=(lines[middle],), faint=tuple(lines[j] for j in near))


def parallel(a: Arrays) -> Parallel:
    factors = np.array([p.factor for p in PARAMETERS])
    axes = tuple(
        ParallelAxis(name=p.symbol, unit=p.unit, low=float(low), high=float(high), log=True)
        for p, low, high in zip(PARAMETERS, LOW / factors, HIGH / factors, strict=True)
    )
    members = np.concatenate([a["members"], CENTRAL[None]]) / factors
    return Parallel(
        title="Sets of parameters that give the three printed critical speeds", axes=axes,
        members=members, highlighted=((len(members) - 1, "fit from mid-range parameters", 0),),
        members_name="sets of parameters",
        note="Each line is a set of parameters that gives all three speeds: the speeds determine "
             "none of the parameters.",
    )  # fmt: skip
