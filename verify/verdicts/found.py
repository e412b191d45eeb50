"""The verdicts of all formulas, computed from the rows of a run, stored studies and errata."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from verify.core.results import Kind, Row
from verify.core.verdicts import FormulaVerdict, Side, Verdict, VerdictRange
from verify.papers.ledger import papers
from verify.studies.sweep.region import Range, regions
from verify.studies.validity.messages import over
from verify.studies.validity.regions import box_words
from verify.verdicts.declared import Formula, declared, errata_of
from verify.verdicts.evidence import Evidence, NoEvidenceError, evidence, joined, point_of
from verify.verdicts.rule import CLASSES, SHARP, Point, above, accuracy, below, judged
from verify.verdicts.words import sentence

LIMITS = CLASSES[1:]  # for which a range is stated: 2, 5 and 10 %


def verdicts(rows: Sequence[Row]) -> tuple[FormulaVerdict, ...]:
    """The verdict of each declared formula, in the order of the papers."""
    known = {row.id: row for row in rows}
    return tuple(
        _verdict(paper.key, paper.cited, formula, known)
        for paper in papers()
        for formula in declared()[paper.key].formulas
    )


def _verdict(paper: str, source: str, formula: Formula, rows: Mapping[str, Row]) -> FormulaVerdict:
    head = FormulaVerdict(
        id=f"{paper}/{formula.name}, {formula.form}", paper=paper, source=source,
        name=formula.name, form=formula.form, what=formula.what,
        verdict=Verdict.DEFINITION, words=formula.defines,
        safe=formula.safe, safe_reason=formula.safe_reason, limited_by=formula.limited_by,
        instead=formula.instead, rows=formula.part, model_rows=formula.model,
        errata=formula.errata,
    )  # fmt: skip
    if formula.defines:
        return head
    if formula.missing:
        return replace(head, verdict=Verdict.UNVERIFIABLE, words=formula.missing)
    try:
        part, model = evidence(formula.part, rows), evidence(formula.model, rows)
        verdict = _of(paper, formula, part, model)
    except NoEvidenceError as error:
        return replace(head, verdict=Verdict.NONE, words=str(error))
    judged_on = part if part.rows else model
    head = replace(head, verdict=verdict, is_of_part=bool(part.rows))
    described = _described(head, judged_on)
    return replace(described, model=_model(model) if part.rows else "", words=sentence(described))


def _of(paper: str, formula: Formula, part: Evidence, model: Evidence) -> Verdict:
    """The verdict of evidence that stands; NoEvidenceError where there is none."""
    rows = (*part.rows, *model.rows)
    if formula.errata:
        _require_shown(paper, formula, [point_of(row) for row in rows])
        return Verdict.WRONG
    if not rows:
        raise NoEvidenceError("nothing is declared that it could be judged by")
    if not part.rows and all(_is_sharp_identity(row) for row in rows):
        return Verdict.EXACT
    judged_on = part if part.rows else model
    return judged(judged_on.points, formula.safe, has_range=judged_on.is_studied)


def _is_sharp_identity(row: Row) -> bool:
    return row.kind is Kind.IDENTITY and row.detects is not None and row.detects <= SHARP


def _require_shown(paper: str, formula: Formula, points: Sequence[Point]) -> None:
    """An erratum changes the number where an error leaves its bar, or where a test shows it."""
    if points and not any(abs(p.error) > p.U for p in points):
        raise NoEvidenceError(f"errata {', '.join(formula.errata)}: the printed form has no error")
    for erratum in errata_of(paper, formula):
        if not points and not erratum.test:
            raise NoEvidenceError(f"erratum {erratum.id} is shown by no row and no test")


def _described(head: FormulaVerdict, found: Evidence) -> FormulaVerdict:
    """With the errors, the ranges and the strength of the evidence."""
    if not found.rows:
        return head
    points = found.points
    worst = max((p for p in points if p.is_paper), key=lambda p: p.size)
    return replace(
        head, error=worst.error, U=worst.U, above=above(points), below=below(points),
        within=accuracy(points), ranges=_ranges(found), points=len(points) - len(found.rows),
        methods=tuple(dict.fromkeys(map(_method, found.rows))),
        shares=tuple(dict.fromkeys(row.shares for row in found.rows if row.shares)),
    )  # fmt: skip


def _method(row: Row) -> str:
    """What the reference of a row is, such as "FE" or "half-space"."""
    return row.partner.by if row.partner is not None and row.fem is None else row.method


def _ranges(found: Evidence) -> tuple[VerdictRange, ...]:
    """Within which ranges of the inputs all rows keep each limit, for each study."""
    return tuple(
        VerdictRange(
            case=plan.case.id, limit=one.limit, words=box_words(one, star=plan.star),
            over=over(plan), box=tuple(map(_side, one.box)), is_star=plan.star,
            inside=one.inside, points=one.points,
        )
        for plan, course in joined(found.studies)
        for one in regions(plan, course, LIMITS)
    )  # fmt: skip


def _side(found: Range) -> Side:
    axis = found.axis
    return Side(
        name=axis.name, symbol=axis.symbol, unit=axis.unit,
        low=axis.shown(found.low), high=axis.shown(found.high),
    )  # fmt: skip


def _model(found: Evidence) -> str:
    """How well the formula solves its own idealisation."""
    if not found.rows:
        return ""
    points = [point_of(row) for row in found.rows]
    if all(_is_sharp_identity(row) for row in found.rows):
        return f"solves its own idealisation within {100 * max(p.size for p in points):.2g} %"
    worst = max(points, key=lambda p: p.size)
    return f"differs from its own idealisation by {100 * worst.error:+.2g} ± {100 * worst.U:.2g} %"
