"""Claims that need no calibration: results of linear dynamics for any dimensions."""

from collections.abc import Callable

import numpy as np

from verify.cases.rotor.sprag.assertions import STATEMENTS
from verify.cases.rotor.sprag.check_types import Drawn, Rounded, Spread, arrays, held_of
from verify.cases.rotor.sprag.formulas import ORDERS
from verify.cases.rotor.sprag.inputs import PRINTED
from verify.cases.rotor.sprag.layout import (
    BETWEEN,
    CENTRAL,
    CLUTCH,
    DISCS,
    GROUNDED,
    INNER,
    OUTER,
    PARTS,
)
from verify.cases.rotor.sprag.response_fem import SHOWN_NODES, SMALL_OFFSETS
from verify.cases.rotor.sprag.system_fem import uneven_clutch_fem
from verify.core.case import Check, Context
from verify.core.figures import Array
from verify.judging.misprints import Misprint
from verify.judging.tolerance_checks import Agreement, Pair, farthest, suites
from verify.papers.ledger import published

ROUND_OFF = 1e-10
LINEAR = 5e-3  # deviation from exponent 1 of torsion over the offset
FREE = 3e-4  # relative to the angular momentum of the inner rotor: 0.1 N m/rad/(J_out Ω²)
NODES = {
    "outer-rotor-elements": OUTER - 1, "outer-rotor-first-node": 1, "outer-rotor-last-node": OUTER,
    "inner-rotor-elements": len(PARTS) - OUTER + 1, "inner-rotor-first-node": OUTER + 1,
    "inner-rotor-last-node": OUTER + INNER, "bearing-1-node": GROUNDED[0],
    "bearing-2-node": GROUNDED[1], "bearing-5-node": GROUNDED[2],
    "bearing-3-outer-node": BETWEEN[0][0], "bearing-3-inner-node": BETWEEN[0][1],
    "bearing-4-outer-node": BETWEEN[1][0], "bearing-4-inner-node": BETWEEN[1][1],
    "clutch-outer-node": CLUTCH[0], "clutch-inner-node": CLUTCH[1],
    "unbalance-1-node": DISCS[0], "unbalance-2-node": DISCS[1],
    "rig-unbalance-1-node": DISCS[0], "rig-unbalance-2-node": DISCS[1],
    **{f"response-node-{node}": node for node in SHOWN_NODES},
}  # fmt: skip


def as_drawn(_: Context) -> float:
    """Positive margin if node numbers and unknowns per node of the model are those printed."""
    unknowns = published("huang2022:commercial-beam-dofs").value
    off = [abs(unknowns - len(uneven_clutch_fem(CENTRAL, 0.0)))]
    off += [abs(published(f"huang2022:{key}").value - node) for key, node in NODES.items()]
    return 0.5 - max(off)


def circles(context: Context) -> float:
    axes = arrays(context)["axes, isotropic"]
    return float(np.abs(axes[..., 1] / axes[..., 0] - 1).max())


def untouched(context: Context) -> float:
    a = arrays(context)
    return float((a["torsion, no offset"].max(axis=2) / a["torsion"].max(axis=2)).max())


def momentum(context: Context) -> float:
    both, inner = np.moveaxis(arrays(context)["momenta"], 1, 0)
    return float((both / inner).max())


def exponents(a: dict[str, Array]) -> Array:
    small = a["torsion, small offsets"]
    steps = np.log(SMALL_OFFSETS[1] / SMALL_OFFSETS[0])
    return np.asarray(np.log(small[:, 1] / small[:, 0]) / steps)


def linear(context: Context) -> Pair:
    """Exponent of the power law of torsion over the offset, and the expected exponent 1.

    The returned exponent is that of the member with the largest difference from 1.
    """
    found = exponents(dict(arrays(context)))
    return farthest(found, np.ones_like(found), 0.0)


def never_between(context: Context) -> tuple[float, str]:
    """Smallest relative rise of node 19's peak from U_2 = 3e-5 to 5e-5 kg m.

    Only members whose peak rises from 1e-5 to 3e-5 kg m are counted; -1 if there are none. The text
    of the row is also returned.
    """
    peaks = arrays(context)["peaks"][:, :, 1, 18]
    peaks = peaks[np.isfinite(peaks).all(axis=1)]
    rising = peaks[:, 1] > peaks[:, 0]
    if not rising.any():
        return -1.0, (
            "as unbalance 2 increases from 1e-5 to 3e-5 kg m, the peak amplitude increases in none "
            f"of the {rising.size} sets that have a peak"
        )
    step = peaks[rising, 2] / peaks[rising, 1] - 1
    words = (
        "as unbalance 2 increases from 1e-5 to 3e-5 kg m, the peak amplitude increases in "
        f"{int(rising.sum())} of the {rising.size} sets that have a peak; as unbalance 2 increases "
        "further to 5e-5 kg m, the peak amplitude increases in all of these sets, by "
        f"{100 * step.min():.0f} % or more, and decreases in "
        f"{int((peaks[:, 1] > peaks[:, 2]).sum())} sets"
    )
    return float(step.min()), words


def at_two_nodes(context: Context) -> tuple[float, str]:
    """Positive margin if unbalance 1 is not at the node with the highest peak, both as printed.

    The text of the row is also returned. It states in how many sets node 11 has the highest peak,
    with unbalance 1 at node 4 (figure of the paper) and at node 11 (text of the paper).
    """
    a = dict(arrays(context))
    highest = next(s for s in STATEMENTS if s.name.endswith("1 to 11 at critical speeds 3 and 5"))
    moved = a | {"peaks": a["peaks, moved"][:, None]}
    words = (
        f"{highest.name} in {held_of(highest, a)} (unbalance 1 at node 4), and in "
        f"{held_of(highest, moved)} (unbalance 1 at node 11)"
    )
    nodes = [published(f"huang2022:{key}").value
            for key in ("outer-highest-node-at-critical-3-and-5", "unbalance-1-node")]  # fmt: skip
    return abs(nodes[0] - nodes[1]) - 0.5, words


def ellipses(context: Context) -> tuple[float, str]:
    a = arrays(context)
    same, other = ((a[f"axes, {k}"][..., 0] / a[f"axes, {k}"][..., 1])
                   for k in ("isotropic", "anisotropic"))  # fmt: skip
    words = (
        "the ratio of the axes of an orbit differs from 1 by at most "
        f"{float(np.abs(same - 1).max()):.0e} if the bearings are equally stiff in x and y; the "
        "median of this ratio exceeds 1 by "
        f"{100 * float(np.median(other[:, 1]) - 1):.1f} % (node 19) and "
        f"{100 * float(np.median(other[:, 0]) - 1):.1f} % (node 4) if k_y of the bearings to the "
        f"ground is {1 + context.inputs.anisotropy:.2g} k_x"
    )
    return float(np.median(other) - 1) - 1e6 * circles(context), words


def no_coupling(context: Context) -> tuple[float, str]:
    p = exponents(dict(arrays(context)))
    words = (
        "torsional rotation at the bending critical speeds is zero for an evenly loaded clutch in "
        "every set; with an offset, this rotation is proportional to a power of the offset with "
        f"the exponent {p.min():.4f} to {p.max():.4f}"
    )
    return 1e-12 - untouched(context), words


def at_one_speed(context: Context) -> tuple[float, str]:
    v = context.analytic
    off = [v[f"frequency_{2 * i + 2}"] * 2 * np.pi / v[f"critical_forward_{k}"] - 1
           for i, k in enumerate(ORDERS)]  # fmt: skip
    words = (
        "the forward natural frequencies at 5000 r/min differ from critical speeds 1, 3 and 5 by "
        + ", ".join(f"{x:+.2%}" for x in off)
    )
    return min(map(abs, off)) - 1e-5, words


def on_the_ground(_: Context) -> tuple[float, str]:
    between = {node for pair in BETWEEN for node in pair}
    wrong = {6, 21} - between
    return 0.5 if wrong <= set(GROUNDED) and wrong else -0.5, (
        "nodes 6 and 21 are on bearings to the ground, and the responses of bearing 3 (nodes 9 and "
        "14), which is between the rotors, are not plotted in the paper"
    )


def of_speed(key: str, i: int) -> Callable[[Context], Array]:
    return lambda context: np.abs(arrays(context)[f"critical, {key}"][:, i] / PRINTED[i] - 1)


def ratio_of_axes(i: int) -> Callable[[Context], Array]:
    def ratio(context: Context) -> Array:
        axes = arrays(context)["axes, anisotropic"][:, i]
        return np.asarray(axes[:, 0] / axes[:, 1])

    return ratio


LINEAR_ROWS: tuple[Check, ...] = (
    Drawn(name="node numbers and unknowns per node are those printed", symbol="", unit="1",
         margin=as_drawn,
         printed=tuple(f"huang2022:{key}" for key in (*NODES, "commercial-beam-dofs"))),
    Rounded(name="amplitudes are convex functions of unbalance 2",
            symbol="Δx/x", unit="1",
            residual=lambda c: max(0.0, float(arrays(c)["convex"].max())), bound=ROUND_OFF,
            scale_name="chord", bound_reason="round-off"),
    Rounded(name="orbits are circles on isotropic bearings", symbol="b/a − 1", unit="1",
            residual=circles, bound=ROUND_OFF, scale_name="semi-major axis",
            bound_reason="round-off"),
    Rounded(name="torsional rotation is zero without offset", symbol="θ_z", unit="1",
            residual=untouched, bound=1e-12, scale_name="torsional rotation with offset",
            bound_reason="round-off"),
    Rounded(name="angular momenta of both rotors balance", symbol="ΣJθ_z", unit="1",
            residual=momentum, bound=FREE, scale_name="angular momentum of the inner rotor",
            bound_reason="stiffness of the drive, 0.1 N m/rad, over J_out Ω² at critical speed 1"),
    Agreement(name="torsional rotation is linear in small offsets", symbol="p", unit="1",
              pair=linear, accepted=LINEAR,
              source=suites("half of the required sensitivity of 1 %"),
              by="theory", everywhere=True),
    *(Spread(name=f"change of critical speed {k} if {what} zero",
             symbol=f"Δn_{k}/n_{k}", unit="%", values=of_speed(key, i))
      for key, what in (
          ("without clutch", "radial and tilting stiffness of the clutch are"),
          ("without clutch across", "the radial stiffness of the clutch is"),
          ("without clutch in tilt", "the tilting stiffness of the clutch is"),
      )
      for i, k in enumerate(ORDERS)),
    *(Spread(name="difference between backward and forward critical speed "
                  f"{k}", symbol=f"Δn_{k}/n_{k}", unit="%",
             values=of_speed("backward", i), words=" of the forward critical speed")
      for i, k in enumerate(ORDERS)),
    *(Spread(name=f"ratio of the axes of the orbit of node {n}, rotors on anisotropic bearings",
             symbol="a/b", unit="1", values=ratio_of_axes(i))
      for i, n in enumerate(DISCS)),
    Misprint(name="statement that a larger unbalance 2 gives a smaller peak of node 19 at critical "
                  "speed 3",
          symbol="x_19", unit="1",
          erratum="huang2022:unbalance-2-third-peak", margin=never_between,
          printed=("huang2022:anomaly-unbalance-with-larger-peak",
                   "huang2022:anomaly-unbalance-with-smaller-peak")),
    Misprint(name="statement that unbalance 1 is at the node with the highest peak",
          symbol="", unit="1", margin=at_two_nodes,
          erratum="huang2022:unbalance-1-location", printed=("huang2022:unbalance-1-node",)),
    Misprint(name="statement that orbits are ellipses without anisotropic stiffness",
          symbol="a/b", unit="1", erratum="huang2022:fig-15-ellipse", margin=ellipses),
    Misprint(name="statement that torque alone causes torsional resonances at bending critical "
                  "speeds",
          symbol="θ_z", unit="1", erratum="huang2022:eq-11-bending-torsion", margin=no_coupling),
    Misprint(name="statement that critical speeds are computed at 5000 r/min", symbol="n", unit="1",
          erratum="huang2022:critical-speed-at-one-speed", margin=at_one_speed,
          printed=("huang2022:comparison-speed",)),
    Misprint(name="statement that the plotted nodes carry the unbalances and the bearings between "
                  "the rotors",
          symbol="", unit="1", erratum="huang2022:response-nodes-reason", margin=on_the_ground),
)  # fmt: skip
