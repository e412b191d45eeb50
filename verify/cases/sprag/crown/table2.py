"""Checks of Table 2 of the paper: consistency of its numbers, and pressures of random crowns."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from verify.cases.sprag.crown.measured_figures import AT
from verify.cases.sprag.statements import FITTED, Beside, Noted, OfPaper, measured
from verify.core.case import Context
from verify.core.figures import Table
from verify.core.results import Kind, Partner, Row
from verify.judging import judge
from verify.judging.checks import Margin
from verify.judging.published_checks import PrintedClaim
from verify.papers.digits import half_last_digit
from verify.papers.ledger import published

ROWS = range(1, 11)
SAMPLE, CUT = 4, 10  # rows: a point of the factorial; an error that was cut off
SURE = 3.0  # standard deviations
COARSE = 0.27  # the change that a printed error's only digit may hide, 5 % of the largest error
MEAN_LEVEL = 0.03  # relative to the pressure to which the wedge angle was fitted


def cell(row: int, column: str) -> float:
    return published(f"huang2018:table2-row{row}-{column}").value


def relative_error(row: int) -> float:
    """Relative error |actual - predicted|/predicted of the values printed in a row."""
    actual, predicted = cell(row, "actual"), cell(row, "predicted")
    return abs(actual - predicted) / predicted


def standardised(row: int) -> float:
    """Ratio of |actual - predicted| [MPa] to the root of the MSE [MPa²] of a row; nan if MSE is 0.

    >>> round(standardised(1), 1)
    11.6
    """
    mse = cell(row, "mse")
    return abs(cell(row, "actual") - cell(row, "predicted")) / math.sqrt(mse) if mse else math.nan


@dataclass(frozen=True, kw_only=True)
class Recomputed(PrintedClaim):
    """Row that compares an error, computed from two printed pressures, with the printed error."""

    kind = Kind.IDENTITY

    analytic: str = ""
    row: int

    def judged(self, context: Context) -> Row:
        v, entry = relative_error(self.row), self._printed_value()
        r, u = entry.value / 100, (entry.standard_uncertainty or 0.0) / 100
        U = judge.expanded(0.0, u)
        verdict = judge.difference(v, r, U=U, scale=r, demand=self.demand)
        return self._row(
            context.case, Kind.IDENTITY, verdict, analytic=v, scale=r, u_num=0.0, u_ref=u,
            u_input=0.0, partner=Partner(by=f"printed {entry.printed}", value=r),
            published=self._beside(),
        )  # fmt: skip


def cut_off(_context: Context) -> tuple[float, float, str]:
    """Amount by which the error computed from the last row exceeds the printed, rounded error."""
    entry = published(f"huang2018:table2-row{CUT}-error")
    v = relative_error(CUT)
    rounds = (entry.value + half_last_digit(entry.printed)) / 100
    return (
        v - rounds,
        0.0,
        f"the printed pressures give the error {v:.4%}; {entry.printed} % is printed",
    )


def too_small(_context: Context) -> tuple[float, float, str]:
    """Mean squared difference of actual and predicted values minus SURE² times the mean MSE [Pa²].

    The uncertainty and the text of the row are also returned.
    """
    d = np.array([cell(k, "actual") - cell(k, "predicted") for k in ROWS if k != SAMPLE])
    mse = np.array([cell(k, "mse") for k in ROWS if k != SAMPLE])
    z = np.abs(d) / np.sqrt(mse)
    words = (
        f"the mean square of the differences between actual and predicted values is "
        f"{np.mean(d**2):.0f} MPa², the mean of MSE is {mse.mean():.1f}; {int((z > SURE).sum())} "
        f"of {z.size} differences exceed {SURE:g} √MSE; the largest difference is {z.max():.1f} "
        "√MSE"
    )
    return float(np.mean(d**2) - SURE**2 * mse.mean()) * 1e12, 0.0, words


def is_a_sample(_context: Context) -> tuple[float, float, str]:
    """Positive margin [Pa²] if both error and MSE of row 4 are zero, otherwise negative.

    The magnitude of the margin is the smallest MSE of the other rows. The uncertainty and the text
    of the row are also returned.
    """
    others = min(cell(k, "mse") for k in ROWS if k != SAMPLE)
    same = cell(SAMPLE, "mse") == 0 and relative_error(SAMPLE) == 0
    words = (
        f"error and MSE are 0; in all other rows MSE is at least {others:g}: kriging interpolates "
        "its sample points"
    )
    return (others if same else -others) * 1e12, 0.0, words


def between(column: str) -> Margin:
    """Function that returns a margin [Pa]: positive if the values of a column belong to 25 N m.

    The pressures of random crowns within Eq. 19 have a range at each torque. All values must lie
    inside the range at 25 N m and below the range at 40 N m.
    """

    def margin(context: Context) -> tuple[float, float, str]:
        p = context.fem[-1].arrays["random p"]
        its = np.array([cell(k, column) for k in ROWS]) * 1e6
        low, high, at_40 = p[:, AT[25]].min(), p[:, AT[25]].max(), p[:, AT[40]].min()
        words = (
            f"the values of Table 2 are {its.min() / 1e6:.0f} to {its.max() / 1e6:.0f} MPa; p_max "
            f"of random crowns is {low / 1e6:.0f} to {high / 1e6:.0f} MPa at 25 N m and at least "
            f"{at_40 / 1e6:.0f} MPa at 40 N m"
        )
        return float(min(its.min() - low, high - its.max(), at_40 - its.max())), 0.0, words

    return margin


def median_25(context: Context) -> float:
    return float(np.median(measured(context)["random p"][:, AT[25]]))


MEDIAN = 3032.6e6  # Pa, of the ten actual values


def demanded(row: int) -> dict[str, Any]:
    """Keyword arguments of a row whose printed error has few digits; otherwise empty.

    They state that the row needs to detect only a larger change than usual.
    """
    entry = published(f"huang2018:table2-row{row}-error")
    asked = (judge.COVERAGE / math.sqrt(3) + 1) * half_last_digit(entry.printed) / entry.value
    if asked <= judge.DEMAND:
        return {}
    return {
        "demand": min(asked, COARSE),
        "demand_reason": f"printed with few digits: {entry.printed} %",
    }


TABLE_2 = (
    *(
        Recomputed(name=f"Table 2, row {k}: error computed from the printed pressures", symbol="ε",
                   unit="%", row=k, reference=f"huang2018:table2-row{k}-error", **demanded(k))
        for k in ROWS if k not in (SAMPLE, CUT)
    ),
    Noted(name=f"Table 2, row {CUT}: error computed from the printed pressures", symbol="ε",
          unit="%",
          erratum="huang2018:table-2-row-10-error", margin=cut_off,
          printed=(f"huang2018:table2-row{CUT}-error",)),
    Noted(name="Table 2: MSE is far below the squared differences of actual and predicted "
          "values", symbol="MSE", unit="MPa^2",
          erratum="huang2018:table-2-mse", margin=too_small,
          printed=tuple(f"huang2018:table2-row{k}-mse" for k in ROWS if k != SAMPLE)),
    Noted(name="Table 2: row 4 is a sample point of kriging", symbol="MSE", unit="MPa^2",
          erratum="huang2018:table-2-row-4", margin=is_a_sample,
          printed=("huang2018:table2-row4-mse", "huang2018:table2-row4-error")),
    *(
        OfPaper(name=f"Table 2: {words} values lie in the range computed for 25 N m",
                symbol="p_max", unit="MPa", margin=between(column), fitted=FITTED,
                printed=tuple(f"huang2018:table2-row{k}-{column}" for k in ROWS))
        for column, words in (("actual", "actual"), ("predicted", "predicted"))
    ),
    Beside(name="Table 2: median of the actual values, compared with that for random crowns",
           symbol="p_max", unit="MPa", value=median_25, figure=MEDIAN, bound=MEAN_LEVEL,
           words="the crowns of Table 2 are not printed; the computed value is the median of 400 "
           "random crowns within the bounds of Eq. 19",
           fitted=f"the wedge angle is fitted to the pressure of Eq. 21; {FITTED}"),
)  # fmt: skip


def table_2() -> Table:
    """Table 2, extended by errors and standardised differences computed from its numbers."""
    rows = [
        (
            float(k), *(published(f"huang2018:table2-row{k}-{name}").printed
                        for name in ("actual", "predicted", "error", "mse")),
            round(100 * relative_error(k), 3), round(standardised(k), 1) if k != SAMPLE else None,
        )
        for k in ROWS
    ]  # fmt: skip
    return Table(
        title="Table 2 with its errors recomputed",
        header=("Row", "Actual [MPa]", "Predicted [MPa]", "Error, printed [%]", "MSE, printed",
                "Error over predicted [%]", "Difference over √MSE"),
        rows=tuple(rows),
        note="The printed error is relative to the predicted value; the recomputed error of the "
        "last row does not round to the printed error. If MSE were the kriging variance in MPa², "
        "nearly all differences would exceed three standard deviations.",
    )  # fmt: skip
