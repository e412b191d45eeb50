"""Claims about kriging: solution of its linear system, errors at new designs, searches."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from analytic.surrogate.bordered import Bordered
from verify.cases.sprag.statements import Measured, OfPaper, measured
from verify.core.case import Context
from verify.core.figures import Array
from verify.core.results import Kind, Row, Status
from verify.judging import judge
from verify.judging.claims import Claim
from verify.judging.tolerance_checks import SUBJECT, Agreement, Deviation, Pair, suites

MEAN, LARGEST, AGREE = 0.005, 0.03, 0.005  # accepted errors of a surrogate: mean, largest, optimum
SEARCHES = 1e-3  # relative difference of searches on the same surrogate
NEAR = 1e-3  # relative excess over the optimum below which a search has found the optimum
BLIND = 0.1  # ratio of an error estimate to the error at new designs below which it is useless
LEFT_OUT = 7  # number of designs left out, one at a time
BOUND = 1e-6  # largest bound by condition number that is conclusive
EPS = float(np.finfo(np.float64).eps)

Named = Callable[[str], Array]  # arrays of a regime by name
Pairs = tuple[Array, Array, float]  # values of both sides, and their scale


def agrees(
    name: str, symbol: str, pair: Callable[[Context], Pair], accepted: float, by: str, source: str
) -> Agreement:
    """Claim on any clutch: two values of the largest pressure agree within `accepted`."""
    return Agreement(name=name, symbol=symbol, unit="MPa", pair=pair, accepted=accepted, by=by,
                     source=source,
                     everywhere=True)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Displayed(Claim):
    """Statement of a computed value without a criterion; its status is SHOWN."""

    kind = Kind.FACT

    words: Callable[[Context], str]

    def rows(self, context: Context) -> list[Row]:
        verdict = judge.Verdict(Status.SHOWN, f"computed: {self.words(context)}")
        return [self._row(context.case, Kind.FACT, verdict, published=self._printed(context))]


@dataclass(frozen=True, kw_only=True)
class Repeated(Claim):
    """Claim that a kriging result agrees with the solution of the bordered linear system.

    The accepted difference follows from the condition number. `pair(context, array, one, extra)`
    returns both values for one kriging model (end slice or other slices), and their scale.
    """

    kind = Kind.EXACT

    pair: Callable[[Context, Named, Bordered, Array], Pairs]

    def rows(self, context: Context) -> list[Row]:
        worst, bound = 0.0, 0.0
        for array, one, extra in regimes(context):
            ours, theirs, scale = self.pair(context, array, one, extra)
            worst = max(worst, float(np.abs(ours - theirs).max()) / scale)
            bound = max(bound, EPS * one.condition)
        verdict = judge.exact(worst, bound=min(bound, BOUND), scale=1.0, demand=self.demand)
        return [
            self._row(
                context.case, Kind.EXACT, verdict, fem=worst, scale=1.0,
                interval_source="round-off error times the condition number of the bordered "
                f"linear system, at most {BOUND:g}",
            )
        ]  # fmt: skip


def regimes(context: Context) -> Iterator[tuple[Named, Bordered, Array]]:
    """Tuples for each kriging model: its arrays by name, bordered system, and extra designs.

    One model is that of the end slice, the second that of all other slices.
    """
    found, box = measured(context), context.inputs.box
    for name in ("end", "inside"):
        if f"{name} designs" in found:
            one = Bordered(
                box.to_unit(found[f"{name} designs"]), found[f"{name} values"],
                found[f"{name} scales"],
            )  # fmt: skip
            yield lambda key, n=name: found[f"{n} {key}"], one, box.to_unit(found["extra"])  # type: ignore[misc]


def at_extra(name: str) -> Callable[[Context, Named, Bordered, Array], Pairs]:
    """Function that returns results at the extra designs by kriging and by the bordered system.

    The result `name` is "predicted" or "deviation"; the scale of the results is also returned.
    """

    def pair(_: Context, array: Named, one: Bordered, extra: Array) -> Pairs:
        return array(name), getattr(one, name)(extra), float(np.abs(one.values).max())

    return pair


def left_out(_: Context, array: Named, one: Bordered, _extra: Array) -> Pairs:
    """Pairs of leave-one-out predictions of some designs, by kriging and by the bordered system.

    The length scales are constant.
    """
    some = np.unique(np.linspace(0, len(one.x) - 1, LEFT_OUT).round().astype(int))
    theirs = np.array([one.left_out(int(k)) for k in some])
    return array("left out")[some], theirs, float(np.abs(one.values).max())


def missed(found: Measured, which: str) -> Array:
    """Relative errors at the extra designs, of one kriging model ("single") or of two ("two")."""
    return np.asarray(found[f"extra {which}"] / found["extra largest"][:, 0] - 1)


def spread(errors: Array) -> str:
    size = np.abs(errors)
    return f"mean {size.mean():.2%}, largest {size.max():.2%}"


def fresh(context: Context) -> tuple[float, float, str]:
    """Mean relative error at the extra designs or, if larger, the scaled largest error.

    The largest error is scaled by MEAN/LARGEST, so that the limit MEAN applies to both.
    """
    error = np.abs(missed(measured(context), "two"))
    size = max(float(error.mean()), float(error.max()) * MEAN / LARGEST)
    return size, 0.0, f"relative error: {spread(error)} (at {len(error)} designs)"


def at_best(context: Context) -> Pair:
    """Pressures [Pa] of the optimal crown by surrogate and by a computed engagement."""
    *_, (*_, predicted, true) = measured(context)["infill"]
    rounds = len(measured(context)["infill"])
    words = (
        f"p_max is {predicted / 1e6:.1f} MPa by the surrogate and {true / 1e6:.1f} MPa by a "
        f"computed engagement after {rounds} rounds of infill; this agreement is the stopping "
        "criterion of infill; independent evidence is given by new designs and by the search "
        "without surrogate"
    )
    return Pair(predicted, true, 0.0, words)


def searched(context: Context) -> Pair:
    """Pair of minima [Pa] of one surrogate: by genetic algorithm, by differential evolution."""
    found = measured(context)
    ga, de = (float(found[f"{name} value"][0]) for name in ("GA", "DE"))
    words = (
        f"the genetic algorithm finds {ga / 1e6:.2f} MPa after "
        f"{found['GA evaluations'][0]:.0f} evaluations, differential evolution finds "
        f"{de / 1e6:.2f} MPa after {found['DE evaluations'][0]:.0f} evaluations"
    )
    return Pair(ga, de, 0.0, words)


def directly(context: Context) -> Pair:
    """Pair: pressure [Pa] of the optimal crown, and lowest found by a search without surrogate."""
    found = measured(context)
    tried, best = found["direct"][:, 3], float(found["best true"][0])
    low = float(tried.min())
    words = (
        f"the search without surrogate finds {low / 1e6:.1f} MPa after {len(tried)} computed "
        f"engagements, {low / best - 1:+.2%} relative to {best / 1e6:.1f} MPa of the optimal crown"
    )
    return Pair(best, low, 0.0, words)


def asked(context: Context) -> str:
    """Text: numbers of engagements that a search computes, with and without a surrogate."""
    found = measured(context)
    tried, best = found["direct"][:, 3], float(found["best true"][0])
    near = tried <= best * (1 + NEAR)
    first = f"{int(np.argmax(near)) + 1}" if near.any() else f"more than {len(tried)}"
    return (
        f"with kriging, the optimum requires {len(found['X'])} computed engagements of the "
        f"factorial and {len(found['infill'])} of infill; without kriging, a search from the given "
        f"crown to within {NEAR:.1%} of the optimum requires {first} computed engagements"
    )


def single_errors(context: Context) -> str:
    found = measured(context)
    return (
        f"errors at the extra designs: {spread(missed(found, 'single'))}; errors estimated by "
        f"omission of one level of the factorial: {spread(found['level out single'])}; errors "
        f"estimated by omission of one design: {spread(found['left out single'])}"
    )


def two_errors(context: Context) -> str:
    found = measured(context)
    return (
        f"errors estimated by omission of one level of the factorial: "
        f"{spread(found['level out two'])}; errors estimated by omission of one design: "
        f"{spread(found['left out two'])}"
    )


def blind(context: Context) -> tuple[float, float, str]:
    """Positive margin if the leave-one-out estimate is less than BLIND times the true error.

    Both are mean relative errors of a single kriging model.
    The uncertainty and the text of the row are also returned.
    """
    found = measured(context)
    known = float(np.abs(found["left out single"]).mean())
    true = float(np.abs(missed(found, "single")).mean())
    return (
        BLIND - known / true,
        0.0,
        f"the estimated mean error is {known:.3%}; the mean error at new designs is {true:.2%}",
    )


def better(context: Context) -> tuple[float, float, str]:
    """Positive margin if two kriging models have less than half of the error of a single model.

    The uncertainty and the text of the row are also returned.
    """
    one, two = (float(np.abs(missed(measured(context), k)).mean()) for k in ("single", "two"))
    return (
        0.5 - two / one,
        0.0,
        f"the mean error is {two:.2%} with separate models and {one:.2%} with a single model",
    )


SURROGATE = (
    Repeated(name="prediction by kriging and by the bordered linear system", symbol="Y", unit="1",
             pair=at_extra("predicted")),
    Repeated(name="standard deviation by kriging and by the bordered linear system", symbol="s",
             unit="1", pair=at_extra("deviation")),
    Repeated(name="leave-one-out predictions in closed form and by omission of each design",
             symbol="Y", unit="1", pair=left_out),
    Deviation(name=f"error of the surrogate at new designs is below {MEAN:.1%} on average and "
              f"below {LARGEST:.0%} at each design",
              symbol="ΔY/Y", unit="1", size=fresh, accepted=MEAN,
              source=suites("the mean error has the tolerance at the optimal crown; the error at "
                            "each design has six times this tolerance"),
              whole="pressure of a computed engagement",
              by="surrogate", everywhere=True),
    agrees(f"pressures of the optimal crown by surrogate and by a computed engagement agree within "
           f"{AGREE:.1%}", "Y", at_best, AGREE, "computed engagement", SUBJECT),
    agrees("lowest pressures by genetic algorithm and by differential evolution agree within "
           f"{SEARCHES:.1%}", "Y", searched, SEARCHES, "differential evolution",
           suites("one fifth of the tolerance between surrogate and computed engagement")),
    agrees("lowest pressures with surrogate and by a search without surrogate agree within "
           f"{AGREE:.1%}", "Pre_max", directly, AGREE, "search without surrogate",
           suites("same tolerance as between surrogate and computed engagement")),
    Displayed(name="number of engagements that a search computes, with and without kriging",
              symbol="n", unit="1", words=asked),
    Displayed(name="errors of a single kriging model of all slices (Eq. 20)", symbol="Y", unit="1",
              words=single_errors),
    Displayed(name="errors of separate kriging models of the end slice and the other slices",
         symbol="Y", unit="1", words=two_errors),
    OfPaper(name="separate kriging models of the end slice and the other slices have less than "
            "half the error of a single model",
            symbol="Y", unit="1", margin=better),
    OfPaper(name="leave-one-out estimates of the error of a single kriging model are less than a "
            "tenth of this error", symbol="Y", unit="1", margin=blind),
)  # fmt: skip
