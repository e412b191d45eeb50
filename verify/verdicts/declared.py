"""Declarations of each formula: evidence, safe side and errata, but not the verdict.

There is one TOML file for each paper. `part` lists rows whose reference is the complete elastic
part. `model` lists rows whose reference makes the same idealisation as the formula.
"""

import tomllib
from functools import cache
from pathlib import Path
from typing import Annotated, Self

from pydantic import Field, StringConstraints, model_validator

from verify.core.verdicts import Form, Safe
from verify.papers.entries import Entry, Erratum, Key, Words
from verify.papers.ledger import Paper, papers

HERE = Path(__file__).parent
RowId = Annotated[str, StringConstraints(pattern=r"^[a-z0-9-]+/.+$")]


class Formula(Entry):
    """A numbered equation in one form, or a design rule, which has a name instead of a number.

    `errata` lists the errata that change the result of this form, `notation` the other errata.
    `defines` is set for a definition and states the defined quantity. `missing` is set for a
    formula that cannot be verified and states the missing datum. `caution` describes a failure that
    the error of the formula does not reveal, and `caution_row` is the row that reveals it.
    `readings` lists rows that use other interpretations of points that the paper leaves open.
    """

    equation: int = Field(default=0, ge=0)
    rule: str = ""
    form: Form = Form.PRINTED
    what: Words
    safe: Safe = Safe.NEITHER
    safe_reason: str = ""
    part: tuple[RowId, ...] = ()
    model: tuple[RowId, ...] = ()
    errata: tuple[Key, ...] = ()
    notation: tuple[Key, ...] = ()
    defines: str = ""
    missing: str = ""
    limited_by: str = ""
    instead: str = ""
    caution: str = ""
    caution_row: str = ""
    readings: tuple[RowId, ...] = ()

    @property
    def rows(self) -> tuple[str, ...]:
        """All rows that are evidence of the formula."""
        return self.part + self.model

    @property
    def name(self) -> str:
        """Number of the equation as text, or name of the rule."""
        return f"Eq. {self.equation}" if self.equation else self.rule

    @model_validator(mode="after")
    def _one_kind_of_verdict_can_follow(self) -> Self:
        where = f"{self.name}, {self.form}"
        if bool(self.equation) == bool(self.rule):
            raise ValueError(f"{where}: give the number of an equation or the name of a rule")
        kinds = [bool(self.defines), bool(self.missing), bool(self.rows or self.errata)]
        if sum(kinds) != 1:
            raise ValueError(f"{where}: give one of defines, missing, or evidence (rows, errata)")
        if self.rows and self.safe is not Safe.NEITHER and not self.safe_reason:
            raise ValueError(f"{where}: safe_reason must state why the safe side is safe")
        if bool(self.caution) != bool(self.caution_row):
            raise ValueError(f"{where}: give caution and caution_row together")
        if self.errata and not self.rows and not self.limited_by:
            raise ValueError(f"{where}: limited_by must state the fault that the errata correct")
        if self.errata and self.form is Form.CORRECTED:
            raise ValueError(f"{where}: only the printed form can have errata")
        return self


class Declarations(Entry):
    """All declared formulas of one paper."""

    formulas: tuple[Formula, ...]

    def of(self, number: int) -> tuple[Formula, ...]:
        """All declared forms of one numbered equation."""
        return tuple(f for f in self.formulas if f.equation == number)


@cache
def declared() -> dict[str, Declarations]:
    """All declarations (key of the paper: declarations).

    Raises ValueError if the declarations of a paper are incomplete.
    """
    found = {}
    for paper in papers():
        text = (HERE / f"{paper.key}.toml").read_text("utf-8")
        found[paper.key] = Declarations.model_validate(tomllib.loads(text))
        _check(paper, found[paper.key])
    return found


def cases_by_paper() -> dict[str, tuple[str, ...]]:
    """Cases with rows that declarations name (key of the paper: ids of the cases)."""
    return {
        key: tuple(dict.fromkeys(
            row.partition("/")[0] for f in one.formulas
            for row in (*f.rows, *f.readings, f.caution_row) if row
        ))
        for key, one in declared().items()
    }  # fmt: skip


def _check(paper: Paper, declarations: Declarations) -> None:
    """Raise ValueError if an equation is not declared completely.

    Each equation must have a declaration. An equation with a misprint must also have one for its
    corrected form.
    """
    known = {erratum.id for erratum in paper.errata}
    for formula in declarations.formulas:
        if unknown := [e for e in formula.errata + formula.notation if e not in known]:
            raise ValueError(f"{paper.key}, {formula.name}: unknown erratum {unknown[0]}")
    for equation in paper.equations:
        if rule := _broken(declarations.of(equation.number)):
            raise ValueError(f"{paper.key}, Eq. {equation.number}: {rule}")


def _broken(forms: tuple[Formula, ...]) -> str:
    """Violated rule of the declared forms of one equation; empty if there is none."""
    kinds = [f.form for f in forms]
    if kinds not in ([Form.PRINTED], [Form.PRINTED, Form.CORRECTED]):
        return "declare the printed form exactly once, and the corrected form at most once"
    if forms[0].errata and len(forms) == 1:
        return "an erratum changes the result: declare the corrected form too"
    if len(forms) > 1 and not (forms[0].errata or forms[0].missing):
        return "no corrected form is allowed: the printed form has no errata and no missing datum"
    return ""


def errata_of(paper: str, formula: Formula) -> tuple[Erratum, ...]:
    """Errata that change the result of a printed form."""
    ledger = next(p for p in papers() if p.key == paper)
    return tuple(e for e in ledger.errata if e.id in formula.errata)


def rows_of_corrected(paper: str, formula: Formula) -> tuple[str, ...]:
    """Rows of the corrected form of a printed equation that has errata."""
    if not formula.errata:
        return ()
    forms = declared()[paper].of(formula.equation) if formula.equation else ()
    return tuple(row for one in forms if one.form is Form.CORRECTED for row in one.rows)


@cache
def safe_sides() -> dict[str, Safe]:
    """Safe sides of rows that are evidence of formulas with a safe side (id of the row: side)."""
    return {
        row: formula.safe
        for paper in declared().values()
        for formula in paper.formulas if formula.safe is not Safe.NEITHER
        for row in formula.rows
    }  # fmt: skip
