"""Verdicts on all formulas, computed from the rows of a run, stored studies and errata."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from verify.core.results import Kind, Row
from verify.core.verdicts import DesignRange, FormulaVerdict, Verdict
from verify.papers.ledger import papers
from verify.verdicts.declared import Formula, declared, errata_of, rows_of_corrected
from verify.verdicts.design import design
from verify.verdicts.evidence import Evidence, NoEvidenceError, evidence, point_of, require
from verify.verdicts.misprint import misprint
from verify.verdicts.regions import ranges
from verify.verdicts.rule import SHARP, Point, above, accuracy, below, judged, on_unsafe_side
from verify.verdicts.words import SMALLEST, joined, sentences


def verdicts(rows: Sequence[Row], key: str = "") -> tuple[FormulaVerdict, ...]:
    """Verdict on each declared formula of one paper, or of all papers in their order."""
    known = {row.id: row for row in rows}
    return tuple(
        _verdict(paper.key, paper.cited, formula, known, rows_of_corrected(paper.key, formula))
        for paper in papers() if key in ("", paper.key)
        for formula in declared()[paper.key].formulas
    )  # fmt: skip


def _verdict(
    paper: str, source: str, formula: Formula, rows: Mapping[str, Row],
    corrected: Sequence[str] = (),
) -> FormulaVerdict:  # fmt: skip
    """Verdict on a formula; `corrected` contains the ids of the rows of its corrected form."""
    head = FormulaVerdict(
        id=f"{paper}/{formula.name}, {formula.form}", paper=paper, source=source,
        name=formula.name, form=formula.form, what=formula.what,
        verdict=Verdict.DEFINITION, words=formula.defines,
        safe=formula.safe, safe_reason=formula.safe_reason, limited_by=formula.limited_by,
        instead=formula.instead, rows=formula.part, model_rows=formula.model,
        errata=formula.errata, caution=formula.caution, caution_row=formula.caution_row,
    )  # fmt: skip
    if formula.defines:
        return head
    try:
        if formula.caution_row:
            require(formula.caution_row, rows, may_be_note=True)
        if formula.missing:
            words = joined((formula.missing, formula.caution))
            return replace(head, verdict=Verdict.UNVERIFIABLE, words=words)
        part, model = evidence(formula.part, rows), evidence(formula.model, rows)
        changed = misprint(part.rows + model.rows, [rows[i] for i in corrected if i in rows])
        verdict = _of(paper, formula, part, model, changed)
        readings = _spread([require(row, rows) for row in formula.readings])
    except NoEvidenceError as error:
        return replace(head, verdict=Verdict.NONE, words=str(error))
    judged_on = part if part.rows else model
    head = replace(head, verdict=verdict, is_of_part=bool(part.rows), readings=readings,
                   misprint=changed if formula.errata else None)  # fmt: skip
    described = _described(head, judged_on)
    return replace(described, model=_model(model) if part.rows else "", words=sentences(described))


def _of(
    paper: str, formula: Formula, part: Evidence, model: Evidence, changed: float | None
) -> Verdict:
    """Verdict on a formula from its evidence.

    Raises NoEvidenceError if there is no evidence.
    """
    rows = (*part.rows, *model.rows)
    if formula.errata:
        _require_shown(paper, formula, [point_of(row) for row in rows], changed)
        return Verdict.WRONG
    if not rows:
        raise NoEvidenceError("no row is declared as evidence of the formula")
    if not part.rows and all(_is_sharp_identity(row) for row in rows):
        return Verdict.EXACT
    judged_on = part if part.rows else model
    ranges_of = _design(judged_on)
    spans_design = all(one.spanned for one in ranges_of)
    has_ranges = set(judged_on.cases) <= {one.case for one in ranges_of}
    # a failure that errors do not reveal excludes a formula from being accurate over its range
    has_range = judged_on.is_studied and has_ranges and spans_design and not formula.caution
    return judged(judged_on.points, formula.safe, has_range=has_range)


def _is_sharp_identity(row: Row) -> bool:
    return row.kind is Kind.IDENTITY and row.detects is not None and row.detects <= SHARP


def _require_shown(
    paper: str, formula: Formula, points: Sequence[Point], changed: float | None
) -> None:
    """Raise NoEvidenceError if errata have no demonstrated effect.

    The effect is demonstrated by a change from the corrected form, by an error that exceeds its
    uncertainty, or by a test.
    """
    has_error = any(abs(p.error) > p.U for p in points)
    if points and not (has_error if changed is None else abs(changed) > SMALLEST):
        raise NoEvidenceError(
            f"errata {', '.join(formula.errata)}: the rows of the printed form reveal no error"
        )
    for erratum in errata_of(paper, formula):
        if not points and not erratum.test:
            raise NoEvidenceError(
                f"erratum {erratum.id} is not demonstrated: declare a row or a test for it"
            )


def _described(head: FormulaVerdict, found: Evidence) -> FormulaVerdict:
    """The verdict with the errors, the ranges and the strength of its evidence."""
    if not found.rows:
        return head
    points = found.points
    row = max(found.rows, key=lambda one: _weight(point_of(one), head))
    worst = point_of(row)
    return replace(
        head, error=worst.error, U=worst.U, worst_row=row.id,
        above=above(points), below=below(points), within=accuracy(points),
        ranges=ranges(found.studies), design=_design(found),
        points=len(points) - len(found.rows), unsolved=found.unsolved,
        own_only=tuple(case for case in found.cases
                       if case not in {plan.case.id for plan, _ in found.studies}),
        methods=tuple(dict.fromkeys(map(_method, found.rows))),
        shares=tuple(dict.fromkeys(row.shares for row in found.rows if row.shares)),
    )  # fmt: skip


def _weight(point: Point, head: FormulaVerdict) -> tuple[float, float]:
    """Sorting key: error on the unsafe side (0 unless the formula is unsafe), then error size."""
    is_unsafe = head.verdict is Verdict.UNSAFE
    return on_unsafe_side([point], head.safe) if is_unsafe else 0.0, point.size


def _method(row: Row) -> str:
    """Method of the reference of a row, such as "FE" or "half-space"."""
    return row.partner.by if row.partner is not None and row.fem is None else row.method


def _design(found: Evidence) -> tuple[DesignRange, ...]:
    return design(found.cases, found.studies)


def _spread(rows: Sequence[Row]) -> str:
    """Text of the range of values from the interpretations that a paper leaves open."""
    values = [row.analytic for row in rows if row.analytic is not None]
    if not values:
        return ""
    low, high = min(values), max(values)
    half = 100 * (high - low) / (high + low)
    return f"{rows[0].symbol} = {low:.3g} to {high:.3g} {rows[0].unit} (±{half:.2g} %)"


def _model(found: Evidence) -> str:
    """Text of the formula's error relative to models with the same simplifications."""
    if not found.rows:
        return ""
    points = [point_of(row) for row in found.rows]
    worst = max(points, key=lambda p: p.size)
    if worst.size < SMALLEST:
        return "solves its idealisation to rounding error"
    if all(_is_sharp_identity(row) for row in found.rows):
        return f"solves its idealisation within {100 * worst.size:.2g} %"
    size = f"{100 * worst.error:+.2g} ± {100 * worst.U:.2g} %"
    return f"relative to a model with the same simplifications, the error is {size}"
