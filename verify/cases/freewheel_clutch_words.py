"""What is told of a freewheel first: its class, what ends its work, what tolerances do."""

import math
from collections.abc import Sequence

from verify.case import Values
from verify.cases.freewheel_clutch_inputs import ClutchInputs
from verify.cases.freewheel_clutch_limits import (
    Limit,
    allowed_shift,
    as_axial_load_grows,
    as_torque_grows,
    end,
    friction_holds,
    of_torque_alone,
    under,
)
from verify.cases.freewheel_clutch_model import light, past_corners
from verify.cases.freewheel_clutch_scatter import DRAWS, slopes

DEGREE = math.degrees(1.0)
MANY = 3  # limits that are told


def findings(q: ClutchInputs, v: Values) -> Sequence[str]:
    found = [f"{light(q, v)}: {verdict(q, v)}"]
    if under(q) is not None and v["mu_0"] <= q.mu:
        found += torque(q, v) + axial(q, v) + tilted(q, v)
    return found + scattered(q, v) + sensitive(q)


def verdict(q: ClutchInputs, v: Values) -> str:
    """Why the class is what it is, and what Coulomb says."""
    if q.T < 0:
        return "the torque turns against the locking direction: the clutch overruns, and the "\
            "criterion does not speak of it"  # fmt: skip
    if v["mu_0"] > q.mu:
        ratio = "" if "safety" not in v else f" (μ/μ_req = {v['safety']:.3g})"
        return f"tan α_0 = {v['mu_0']:.4g} exceeds μ = {q.mu:g}: the clutch releases itself, any "\
            f"torque drives the rollers out of their wedges{ratio}"  # fmt: skip
    if q.T == 0:
        if q.F_ax == 0:
            return f"at rest; tan α_0 = {v['mu_0']:.4g} is within μ = {q.mu:g}, the rollers wedge"
        return f"without torque nothing presses the rollers: F_ax = {_newton(q.F_ax)} meets no "\
            "friction"  # fmt: skip
    if "safety" not in v:
        last = "pop_through" if math.isfinite(of_torque_alone(q).pop_through) else "hertz"
        return f"no state bears T = {q.T:.4g} N m: {Limit(last, end(q)).words} at {end(q):.4g} N m"
    needs = f"torque and axial load ask for {v['mu_req']:.4g}, friction is {q.mu:g}"
    ratio = f"μ/μ_req = {v['safety']:.4g}"
    if past_corners(q, v):
        alone = "friction alone would hold" if v["safety"] >= 1 else "friction would slip, too"
        at = f"T_c = {v['T corner']:.4g} N m"
        return f"the rollers are past the flats' corners ({at}); {alone}, {ratio}"
    if light(q, v) == "overloaded":
        return f"{ratio}: friction holds ({needs}), {beyond(q, v)}"
    if v["safety"] >= 1:
        return f"{ratio}: by Coulomb's law it holds ({needs})"
    seen = "; yellow is what the paper grants by observation" if light(q, v) == "yellow" else ""
    return f"{ratio}: by Coulomb's law it slips ({needs}){seen}"


def beyond(q: ClutchInputs, v: Values) -> str:
    """What of an overloaded clutch is beyond its limit."""
    found = []
    if q.p_lim is not None and v.get("p_end", math.inf) > q.p_lim:
        even = max(v["p_i"], v["p_o"])
        part = "inner" if v["p_i"] >= v["p_o"] else "outer"
        bear = f"the {part} contacts bear {_pascal(even)}" if even > q.p_lim else \
            f"the rollers' ends bear {_pascal(v['p_end'])}" if "p_end" in v else \
            "one end of the rollers bears everything"  # fmt: skip
        found.append(f"contacts are overloaded: {bear}, p_lim is {_pascal(q.p_lim)}")
    if v["e/L"] > allowed_shift(q):
        found.append(f"the rollers tilt: e/L = {v['e/L']:.3g} is beyond {allowed_shift(q):.3g}")
    return " and ".join(found)


def torque(q: ClutchInputs, v: Values) -> list[str]:
    """What comes first when the torque grows and the axial load stays."""
    limits = as_torque_grows(q)
    passed = [limit for limit in limits if limit.at < q.T]
    ahead = [limit for limit in limits if limit.at > q.T]
    ahead = [limit for k, limit in enumerate(ahead) if k == 0 or limit.key != "hertz"]
    found = [
        f"already beyond a limit of the torque: {limit.words} at {limit.at:.4g} N m"
        for limit in passed
    ]
    if v["safety"] < 1:
        ranges = [f"{a:.4g} to {b:.4g} N m" if math.isfinite(b) else f"{a:.4g} N m on"
                  for a, b in friction_holds(q)]  # fmt: skip
        told = f"from {' and from '.join(ranges)}" if ranges else "at no torque"
        found.append(f"friction would bear F_ax = {_newton(q.F_ax)} {told}")
    if ahead:
        found.append(f"as the torque grows: {_listed(ahead, q.T, 'N m', 'T')}")
    if (least := v.get("T bears", 0.0)) > 0:
        found.append(
            f"as the torque falls: below {least:.4g} N m ({least / q.T:.3g} T) friction no longer "
            f"bears F_ax = {_newton(q.F_ax)}"
        )
    return found


def axial(q: ClutchInputs, v: Values) -> list[str]:
    """What comes first when the axial load grows and the torque stays."""
    if v["F slip"] == 0:
        return ["friction bears no axial load at this torque"]
    limits = as_axial_load_grows(q)
    passed = [limit for limit in limits if limit.at < q.F_ax]
    ahead = [limit for limit in limits if limit.at >= q.F_ax]
    found = [
        f"already beyond a limit of the axial load: {limit.words} at {_newton(limit.at)}"
        for limit in passed
    ]
    if ahead:
        found.append(f"as the axial load grows: {_listed(ahead, q.F_ax, 'N', 'F_ax')}")
    return found


def tilted(q: ClutchInputs, v: Values) -> list[str]:
    if q.F_ax == 0:
        return []
    end = f"{v['p_end'] / 1e6:.4g} MPa at one end" if "p_end" in v else "without bound at one end"
    return [
        f"the axial forces' couple tilts the rollers: contact forces move by {v['e/L']:.2g} L and "
        f"the pressure is {end}; the criterion does not contain this"
    ]


def scattered(q: ClutchInputs, v: Values) -> list[str]:
    if "P(slip)" not in v:
        return []
    given = [
        f"±{t * 1e6:.3g} µm on {name}"
        for name, t in (("X", q.X_tol), ("r", q.r_tol), ("R", q.R_tol)) if t > 0
    ] + ([f"μ {q.mu:g} ± {q.s_mu:g}"] if q.s_mu > 0 else [])  # fmt: skip
    shares = ", ".join(f"{_share(v[f'share {c}'])} {c}" for c in ("green", "yellow", "red"))
    through = "let the rollers through" if not q.is_star else "have contacts too wide to tell"
    lost = [
        f"{_share(v[f'P({key})'])} {words}"
        for key, words in (("no wedge", "have no wedge"), ("no state", through),
                           ("corner", "have rollers past the flats' corners"))
        if f"P({key})" in v
    ]  # fmt: skip
    spread = ""
    if "alpha, 5 %" in v:
        spread = (
            f"; 90 % of those that wedge have α_0 from {v['alpha_0, 5 %'] * DEGREE:.3f}° to "
            f"{v['alpha_0, 95 %'] * DEGREE:.3f}° and μ/μ_req from {v['safety, 5 %']:.3g} to "
            f"{v['safety, 95 %']:.3g}"
        )
    told = ", ".join([*lost, f"{_share(v['P(slip)'])} slip"])
    return [f"of {DRAWS:,} clutches with {', '.join(given)}: {told} (by friction {shares}){spread}"]


def sensitive(q: ClutchInputs) -> list[str]:
    by = slopes(q)
    turned = ", ".join(f"1 µm on {s.name} by {s.slope * 1e-6 * DEGREE:+.3f}°" for s in by)
    shares = [s for s in sorted(by, key=lambda s: -s.share) if s.share > 0]
    told = ", ".join(f"{s.name} {100 * s.share:.0f} %" for s in shares)
    return [f"α_0 turns: {turned}" + (f"; of its variance come from {told}" if told else "")]


def warnings(q: ClutchInputs, v: Values) -> Sequence[str]:
    found = reached(q)
    if q.p_lim is not None and v.get("p_end", 0.0) > q.p_lim:
        found.append(
            f"{v['p_end'] / 1e6:.4g} MPa at the rollers' ends exceed p_lim = "
            f"{q.p_lim / 1e6:.4g} MPa: the surfaces yield"
        )
    if v.get("e/L", 0.0) > allowed_shift(q):
        found.append(f"e/L = {v['e/L']:.3g} is beyond {allowed_shift(q):.3g}: the rollers tilt")
    return found


def reached(q: ClutchInputs) -> list[str]:
    """Whether tolerances use up what a wedge is made of."""
    used, room = q.X_tol + 2 * q.r_tol + q.R_tol, q.room
    if used < room:
        return []
    rule = "R - 2 r - X" if q.is_star else "R + 2 r - X"
    return [
        f"tolerances reach {rule} = {room * 1e6:.4g} µm: X_tol + 2 r_tol + R_tol = "
        f"{used * 1e6:.4g} µm, parts within them may have no wedge"
    ]


def _listed(limits: Sequence[Limit], now: float, unit: str, symbol: str) -> str:
    """Limits one after the other, the first with its margin over the load now."""
    told = []
    for k, limit in enumerate(limits[:MANY]):
        at = _newton(limit.at) if unit == "N" else f"{limit.at:.4g} {unit}"
        margin = f", {limit.at / now:.3g} {symbol}" if now > 0 else ""
        told.append(f"{'first ' if k == 0 else ''}{limit.words} ({at}{margin})")
    return ", then ".join(told)


def _pascal(p: float) -> str:
    return f"{p / 1e6:.4g} MPa" if p < 1e10 else f"{p / 1e9:.3g} GPa"


def _newton(F: float) -> str:
    return f"{F:.4g} N" if F < 1e4 else f"{F / 1e3:.4g} kN"


def _share(share: float) -> str:
    """A share of the draws in per cent; a single draw is 0.005 %."""
    if share == 0:
        return "none"
    return "all" if share == 1 else f"{100 * share:.3g} %"
