"""Explanation of rows that do not compare a pair of values: orders, limits, balances, facts."""

from verify.core.results import Row, Status
from verify.judging import judge
from verify.judging.claims import convergence_verdict
from verify.judging.convergence import LEAST_ORDER, fit_order, order_from_iteration
from verify.judging.explain.grid import grid_steps, regrid, uncertainty_steps
from verify.judging.explain.lines import (
    Derivation,
    Step,
    amount,
    demand,
    difference_steps,
    expanded,
    long,
    sharpness,
    short,
)

WORDS = {Status.PASS: "holds", Status.FAIL: "does not hold"}


def trend(row: Row) -> Derivation:
    """Derivation of the verdict on the order with which errors decrease."""
    assert row.analytic is not None
    if row.levels_u:
        return coefficient(row, row.analytic)
    h, errors = zip(*row.levels, strict=True)
    fit = fit_order(h, errors)
    U = judge.expanded(fit.u)
    verdict = judge.difference(fit.order, row.analytic, U=U, scale=row.analytic, demand=demand(row))
    scatter, correction, round_off = map(short, fit.parts)
    found = (
        *((f"h = {a:.4g}", f"relative error {short(e)}") for a, e in row.levels),
        ("slopes", ", ".join(f"{p:.5f}" for p in fit.slopes) + " between neighbouring levels"),
        ("order", f"p = {fit.order:.5f}, extrapolated from the last three slopes to h = 0"),
        (
            "u_num",
            "scatter about this extrapolation, half of its last correction c h, and round-off: "
            f"√({scatter}² + {correction}² + {round_off}²) = {short(fit.u)}",
        ),
        expanded("1", fit.u, 0.0, 0.0, U),
        ("theory", f"{row.analytic:g}"),
        *difference_steps(row, verdict, "theory − observed"),
    )
    return Derivation(found, verdict, fit.u)


def coefficient(row: Row, theory: float) -> Derivation:
    """Derivation of the verdict on the leading coefficient of the error of a formula."""
    eps, d = zip(*row.levels, strict=True)
    c, U = judge.quadratic_coefficient(eps, d, row.levels_u)
    verdict = judge.difference(c, theory, U=U, scale=abs(theory), demand=demand(row))
    points = zip(row.levels, row.levels_u, strict=True)
    found = (
        *((f"ε = {e:.4g}", f"formula/FE − 1 = {y:+.4e}, u = {short(u)}") for (e, y), u in points),
        ("fit", f"c ε² + e ε⁴ with c = {c:+.5f}; U is the sum of all u: {short(U)}"),
        ("theory", f"{theory:g}"),
        *difference_steps(row, verdict, "theory − observed"),
    )
    return Derivation(found, verdict, U / judge.COVERAGE)


def limit(row: Row) -> Derivation:
    """Derivation of the verdict on a formula that becomes exact as a parameter approaches zero."""
    eps, d = zip(*row.levels, strict=True)
    fit = judge.fit_limit(eps, d, row.levels_u)
    verdict = judge.asymptotic(fit, q=row.formal_order, scale=1.0, demand=demand(row))
    points = zip(row.levels, row.levels_u, strict=True)
    found: list[Step] = [
        *((f"ε = {e:.4g}", f"formula/FE − 1 = {y:+.4e}, u = {short(u)}") for (e, y), u in points),
        ("fit", f"d0 + c ε^q with d0 = {fit.d0:+.4e}, c = {short(fit.c)}, q = {fit.q:.4f}"),
        ("U0", f"twice the sum of all u, or the scatter of the points: {short(fit.U0)}"),
        ("test", f"|d0| ≤ U0, that is {short(abs(fit.d0))} ≤ {short(fit.U0)}: "
         f"{'holds' if abs(fit.d0) <= fit.U0 else 'does not hold'}"),
    ]  # fmt: skip
    if row.formal_order is not None:
        off = abs(fit.q - row.formal_order)
        held = "holds" if off <= fit.U_q else "does not hold"
        found.append(("exponent", f"|q − {row.formal_order:g}| ≤ U_q, that is {short(off)} ≤ "
                      f"{short(fit.U_q)}: {held}"))  # fmt: skip
    found.append(sharpness(row, verdict, f"U0 + |d0| = {short(fit.U0)} + {short(abs(fit.d0))}"))
    return Derivation(tuple(found), verdict)


def exact(row: Row) -> Derivation:
    """Derivation of the verdict on a balance that must hold to round-off."""
    assert row.fem is not None
    assert row.scale is not None
    assert row.tolerance is not None
    bound = row.tolerance / row.scale
    verdict = judge.exact(row.fem, bound=bound, scale=row.scale, demand=demand(row))
    found = (
        ("residual", f"{amount(row.fem, row.unit)} on the finest mesh"),
        ("bound", f"{bound:g} of the scale: {row.interval_source}"),
        ("U", f"bound × scale = {bound:g} × {short(row.scale)} = "
         f"{amount(verdict.tolerance, row.unit)}"),
        *difference_steps(row, verdict, "residual"),
    )  # fmt: skip
    return Derivation(found, verdict)


def fact(row: Row) -> Derivation:
    """Derivation of the verdict on a statement with a margin."""
    assert row.difference is not None
    assert row.tolerance is not None
    verdict = judge.fact(row.difference, row.tolerance)
    found: list[Step] = []
    if row.analytic is not None and row.partner is not None:
        found += [
            ("formula", amount(row.analytic, row.unit, long)),
            ("reference", f"{amount(row.partner.value, row.unit)}, {row.partner.by}"),
        ]
    found.append(("test", f"margin > U, that is {amount(row.difference, row.unit)} > "
                  f"{amount(row.tolerance, row.unit)}: {WORDS[verdict.status]}"))  # fmt: skip
    restated = row.status in (Status.NOTE, Status.CALIBRATED)  # misprint, or fitted inputs
    if restated and verdict.status is Status.PASS:
        verdict = judge.Verdict(row.status, row.reason, verdict.difference, verdict.tolerance)
    return Derivation(tuple(found), verdict)


def convergence(row: Row) -> Derivation:
    """Derivation of the verdict on the convergence of finite-element values."""
    assert row.grid is not None
    g = row.grid
    again, _ = regrid(g)
    h, v = zip(*g.levels, strict=True)
    verdict = convergence_verdict(again, h, v, g.u_it, g.allowed)
    found = grid_steps(g)
    word = WORDS[verdict.status]
    if again.behaviour == "monotone" and again.order is not None:
        margin, noise = again.order - LEAST_ORDER, order_from_iteration(h, v, g.u_it)
        found.append(
            (
                "test",
                "order − 0.5 > change of the order if values differ by ± u_it: "
                f"{margin:.4g} > {short(noise)}: {word if margin > noise else 'undecided'}",
            )
        )
        if not margin > noise:
            spread = 3 * (max(v[-3:]) - min(v[-3:]))
            found.append(("test", f"3 × spread < required sensitivity × scale, at any order: "
                          f"{short(spread)} < {amount(g.allowed, g.unit)}: {word}"))  # fmt: skip
    elif again.behaviour != "round-off" and again.converges:
        found += uncertainty_steps(g)[:1]
        found.append(("test", f"GCI < required sensitivity × scale, without an order: "
                      f"{short(again.gci)} < {amount(g.allowed, g.unit)}: {word}"))  # fmt: skip
    else:
        found.append(
            (
                "test",
                f"the differences are round-off: {word}" if again.converges else "not converged",
            )
        )
    return Derivation(tuple(found), verdict)
