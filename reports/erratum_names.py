"""Readable names of errata, derived from their keys in the ledgers."""

import re
from collections.abc import Mapping

_PLACE = re.compile(r"(eq|eqs|fig|sec|table)-((?:\d+-)+)")
_SYMBOL = re.compile(r"\b([a-z])-([a-z])\b")
KINDS = {"eq": "Eq", "eqs": "Eq", "fig": "Fig", "sec": "Sec", "table": "Table"}
# subjects of keys that are not readable as words
SUBJECTS: Mapping[str, str] = {
    "arc-radius": "radius of the arcs",
    "beam-name": "name of the beam theory",
    "critical-speed-at-one-speed": "critical speeds computed at one speed",
    "crown-reference": "cited source of the crown",
    "diameter-d-i": "diameter d_i of a polygonal bore",
    "eq-1-a-undefined": "A is not defined",
    "eq-1-clipping": "drop in the straight middle of the roller",
    "eq-1-e-prime": "definition of E′",
    "eq-1-profile-load": "load Q of the profile",
    "eq-1-text-tangent": "tangent of the clamping angle in the text",
    "eq-2-separators": "separators of the equalities",
    "eq-2-tangent-or-secant": "tangent or secant stiffness",
    "eq-3-4-5-first-index": "indices of the first entries",
    "eq-3-angle-symbol": "symbol of the angular position",
    "eq-3-first-moment-index": "index of the first couple",
    "eq-3-leaf-length": "length of a leaf",
    "eq-3-leaf-moment": "moment in a leaf",
    "eq-3-lever-on-the-flat": "lever arm on the flat",
    "eq-3-moment-m4": "symbol M_4 in the text",
    "eq-3-moment-not-force": "couple called a force",
    "eq-3-moment-recursion": "recursion of the couples",
    "eq-4-argument": "variable of integration",
    "eq-5-coordinate": "coordinate of a slice",
    "eq-5-denominator-signs": "signs in the denominator",
    "eq-5-exponent": "exponent 1/ex",
    "eq-5-inequality": "inequality instead of an equation",
    "eq-5-odd-n": "sign for odd n",
    "eq-5-range": "range of θ",
    "eq-7-rolling": "rotation by rolling",
    "eq-7-width": "width b is not defined",
    "eq-8-one-direction": "same direction assumed for displacement and tilt",
    "eq-8-preload": "preload twist is missing",
    "eq-8-two-tangents": "second definition of tan α",
    "eq-9-centrifugal": "centrifugal growth of the outer race is missing",
    "eq-9-sprag-index": "index of the sprag angle",
    "eq-9-torque-row": "row of the torque is missing",
    "eq-10-eta": "definition of η",
    "eq-10-gamma-missing": "γ, ω and OC_g are not computed",
    "eq-10-increments": "valid for small increments of the displacements only",
    "eq-10-initial-angle": "initial angle θ_i",
    "eq-10-inner-deflection": "deflections at the inner contact",
    "eq-10-stage-ends": "ends of the stages",
    "eq-10-strictness": "whether the limit itself is permitted",
    "eq-10-theta": "brackets of the logarithm for θ",
    "eq-10-units": "units are missing",
    "eq-11-14-spring-sign": "sign of the spring term",
    "eq-11-bending-torsion": "coupling of bending and torsion",
    "eq-11-equal-stiffness": "one stiffness for all stages",
    "eq-11-symbols": "indices of the deflections",
    "eq-12-k-squared": "K is contained twice",
    "eq-12-static-limit": "formula of the static friction limit",
    "eq-12-symbol": "symbol of the relative displacement",
    "eq-12-test-range": "largest displacement of the tests",
    "eq-13-controlling-number": "ratio that governs the sideways stiffness",
    "eq-13-printed-spring": "limit that the paper's spring exceeds",
    "eq-13-side-force": "force on a side of the polygon",
    "eq-14-mass": "mass of the sprag",
    "eq-15-h": "symbol h",
    "eq-15-lever": "lever arm of the hub force",
    "eq-16-damping-symbol": "symbol of the damping",
    "eq-16-gamma": "angle γ of the hub force",
    "eq-16-outer-spring": "support of the outer race",
    "eq-16-torque-symbol": "symbol of the torque",
    "eq-17-reference": "number of the equation of the hub force",
    "eq-21-22-ends": "pressure at the ends of the optimal crowns",
    "eq-21-factor": "additional factor on the left side",
    "eq-21-no-pressure-limit": "condition for the required pressure",
    "eqs-17-20-side-force": "force on a side of the polygon",
    "fea-error-small-compression": "error of the finite-element force at small compressions",
    "fig-12-load": "load of the compared crowns",
    "fig-13-first-contact": "place of the first contact",
    "fig-13-parameter": "parameter that increases",
    "fig-14-k1": "K_1 of the crown with the lowest stress",
    "fig-15-ellipse": "shape of the orbits",
    "introduction-section-numbers": "section numbers in the introduction",
    "k-without-values": "values of K",
    "p1-meaning": "meaning of p_1",
    "part-3": "names of part 3",
    "part-10": "names of part 10",
    "part-12": "part number of the elastic ring",
    "psi-definition": "definition of ψ",
    "requirements-garbled": "list of requirements",
    "requirements-radial-load": "radial load in the requirements",
    "response-abbreviation": "abbreviation of the frequency response",
    "response-nodes-reason": "reason for the plotted nodes",
    "roller-load-pressure": "roller force called a pressure",
    "s-i-arc-angle": "angle of the arc in segment S I",
    "sec-2-3-spring-stiffness": "stiffness K_r of the springs",
    "sec-2-4-race-deflections": "size of the race deflections",
    "sec-4-1-overall-drop": "parameter that sets the overall drop",
    "sec-4-1-straight-length": "length of the straight middle",
    "sec-4-2-2-percentage": "reduction of the stress in per cent",
    "sec-4-2-force-ratio": "ratio of the contact forces",
    "sec-4-2-unmodified-peak": "peak pressure without crown",
    "sec-4-2-z-m-trend": "trend of z_m with the torque",
    "self-locking-condition": "condition against self-locking",
    "slice-called-sprag": "slice called a sprag",
    "slip-criterion-number": "equation of the slip criterion",
    "stiffness-step-wording": "size of the increase from k_1 to k_2",
    "symbol-e-r": "symbol e_r has several meanings",
    "symbol-f-e": "index e has two meanings",
    "symbol-h": "symbol h has two meanings",
    "symbol-n": "symbol n has several meanings",
    "symbol-nu": "symbol ν has two meanings",
    "symbol-rho": "symbol ρ has two meanings",
    "symbol-theta": "symbols θ and x have two meanings",
    "symbol-x": "symbol x has several meanings",
    "symbol-z": "symbol z has several meanings",
    "symbols-reused": "symbols with several meanings",
    "table-1-radii": "three equal inner radii",
    "table-2-mse": "unit of the MSE",
    "table-2-relative-error": "definition of the relative error",
    "table-2-row-4": "kind of point in row 4",
    "table-2-row-10-error": "relative error of row 10",
    "table-2-torque": "torque is not stated",
    "tail-contact-at-the-same-time": "head and tail touch the leaves at the same time",
    "tail-support": "fixed part of the tail",
    "theory-error-six-percent": "stated error of the theory, 6 %",
    "traffic-light-wording": "wording of the coloured classes",
    "unbalance-1-location": "location of unbalance 1",
    "unbalance-2-third-peak": "dependence of the peak at critical speed 3 on unbalance 2",
    "unbalanced-mass-unit": "unit of the unbalanced mass",
    "yield-strength": "yield strength of the strip",
    "z-m-unit": "unit of z_m",
}


def erratum_name(key: str) -> str:
    """Name of an erratum with its place and subject.

    >>> erratum_name("eq-9-axial-force-per-roller"), erratum_name("eq-3-4-5-first-index")
    ('Eq. 9: axial force per roller', 'Eqs. 3, 4, 5: indices of the first entries')
    >>> erratum_name("sec-4-2-a-b-trend"), erratum_name("table-1-radii"), erratum_name("arc-radius")
    ('Sec. 4.2: a_b trend', 'Table 1: three equal inner radii', 'radius of the arcs')
    """
    place = _PLACE.match(key)
    plain = _SYMBOL.sub(r"\1_\2", key[place.end() :] if place else key).replace("-", " ")
    subject = SUBJECTS.get(key, plain)
    return f"{_words(place[1], place[2].split('-')[:-1])}: {subject}" if place else subject


def _words(kind: str, numbers: list[str]) -> str:
    if kind == "sec":
        return f"Sec. {'.'.join(numbers)}"
    plural = "s" if len(numbers) > 1 else ""
    mark = "" if kind == "table" else "."
    return f"{KINDS[kind]}{plural}{mark} {', '.join(numbers)}"
