"""Input data for the ROSS script from rotors of `fem.rotor`."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from fem.rotor.model import Link, Rotor, Support


def asked(
    rotor: Rotor, speeds: Sequence[float], count: int, unbalance: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """Input data for ROSS: rotor with `rotor.refine` elements per piece, and requested results.

    `unbalance` contains nodes, magnitudes [kg m], phases [rad], speeds [rad/s] and the node of the
    probe. Raises ValueError if a speed ratio is not 1, or if a bearing depends on the speed of
    rotation or acts in other directions than x and y.
    """
    if any(shaft.ratio != 1 for shaft in rotor.shafts):
        raise ValueError("ROSS has one speed for all coaxial shafts: all speed ratios must be 1")
    known = dict(unbalance or {})
    if known:
        known["nodes"] = [refined(rotor, n) for n in known["nodes"]]
        known["probe"] = refined(rotor, known["probe"])
    return {
        "shafts": [_pieces(rotor, k) for k in range(len(rotor.shafts))],
        "discs": [
            (refined(rotor, d.node), d.mass, d.diametral, d.polar) for d in rotor.discs
        ],
        "bearings": [_bearing(rotor, one) for one in (*rotor.supports, *rotor.links)],
        "speeds": [float(w) for w in speeds], "count": count, "unbalance": known,
    }  # fmt: skip


def refined(rotor: Rotor, node: int) -> int:
    """Number that the node `node` has after each piece is divided into `rotor.refine` elements."""
    shaft = int(rotor.shaft_of[node])
    inside = node - int(rotor.first_nodes[shaft])
    before = sum(rotor.refine * len(s.elements) + 1 for s in rotor.shafts[:shaft])
    return before + rotor.refine * inside


def write(question: Mapping[str, Any], path: Path) -> Path:
    path.write_text(json.dumps(question, indent=1), "utf-8")
    return path


def _pieces(rotor: Rotor, shaft: int) -> list[dict[str, float]]:
    return [
        {"length": e.length / rotor.refine, "d_i": e.d_i, "d_o": e.d_o, "E": e.material.E,
         "nu": e.material.nu, "rho": e.material.rho, "kappa": e.kappa}
        for e in rotor.shafts[shaft].elements for _ in range(rotor.refine)
    ]  # fmt: skip


def _bearing(rotor: Rotor, one: Any) -> dict[str, Any]:
    """Lateral stiffness and damping of a support or of a link between two nodes."""
    if isinstance(one, Support):
        K, C, ends = one.K, one.C, {"n": refined(rotor, one.node)}
    elif isinstance(one, Link):
        K, C = one.stiffness, one.damping
        ends = {"n": refined(rotor, one.a), "n_link": refined(rotor, one.b)}
    else:
        raise ValueError("a bearing for ROSS must not depend on the speed of rotation")
    beyond = np.array([np.delete(A, (0, 1), axis=0) for A in (K, C)])
    if np.any(beyond):
        raise ValueError("a bearing for ROSS must act in x and y only")
    named = {f"{letter}{'xy'[i]}{'xy'[j]}": float(A[i, j])
             for letter, A in (("k", K), ("c", C)) for i in (0, 1) for j in (0, 1)}  # fmt: skip
    return ends | named
