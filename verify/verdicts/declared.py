"""Declarations of each formula: its evidence, its safe side, its errata; never its verdict.

One TOML file for each paper. `part` names rows whose reference is the part itself, elastic and
whole; `model` rows whose reference shares the formula's idealisation.
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
    """A numbered equation in one form, or a design rule that has a name in place of a number.

    `errata` change the number of this form, `notation` lists those that do not. A definition names
    what it `defines`; a formula that cannot be verified names the `missing` datum. `caution` names
    a failure that no error of the formula shows, and the row that does; `readings` are rows whose
    formulas use other readings of the paper's open points.
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
        """All rows that it rests on."""
        return self.part + self.model

    @property
    def name(self) -> str:
        """The equation's number, or the rule's name."""
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
            raise ValueError(f"{where}: say why the safe side is safe in safe_reason")
        if bool(self.caution) != bool(self.caution_row):
            raise ValueError(f"{where}: give caution and caution_row together")
        if self.errata and not self.rows and not self.limited_by:
            raise ValueError(f"{where}: say in limited_by what is wrong")
        if self.errata and self.form is Form.CORRECTED:
            raise ValueError(f"{where}: errata belong to the printed form")
        return self


class Declarations(Entry):
    """All formulas of one paper."""

    formulas: tuple[Formula, ...]

    def of(self, number: int) -> tuple[Formula, ...]:
        """The forms of one numbered equation."""
        return tuple(f for f in self.formulas if f.equation == number)


@cache
def declared() -> dict[str, Declarations]:
    """The declarations by the key of their paper; ValueError if they are not complete."""
    found = {}
    for paper in papers():
        text = (HERE / f"{paper.key}.toml").read_text("utf-8")
        found[paper.key] = Declarations.model_validate(tomllib.loads(text))
        _check(paper, found[paper.key])
    return found


def cases_by_paper() -> dict[str, tuple[str, ...]]:
    """The cases whose rows the formulas of each paper name, by the key of the paper."""
    return {
        key: tuple(dict.fromkeys(
            row.partition("/")[0] for f in one.formulas
            for row in (*f.rows, *f.readings, f.caution_row) if row
        ))
        for key, one in declared().items()
    }  # fmt: skip


def _check(paper: Paper, declarations: Declarations) -> None:
    """Each equation has a verdict; a misprinted equation also has one for its corrected form."""
    known = {erratum.id for erratum in paper.errata}
    for formula in declarations.formulas:
        if unknown := [e for e in formula.errata + formula.notation if e not in known]:
            raise ValueError(f"{paper.key}, {formula.name}: there is no erratum {unknown[0]}")
    for equation in paper.equations:
        if rule := _broken(declarations.of(equation.number)):
            raise ValueError(f"{paper.key}, Eq. {equation.number}: {rule}")


def _broken(forms: tuple[Formula, ...]) -> str:
    """Broken rule of the forms of one equation; empty if none is broken."""
    kinds = [f.form for f in forms]
    if kinds not in ([Form.PRINTED], [Form.PRINTED, Form.CORRECTED]):
        return "declare it as printed, once"
    if forms[0].errata and len(forms) == 1:
        return "an erratum changes its number: declare the corrected form too"
    if len(forms) > 1 and not (forms[0].errata or forms[0].missing):
        return "nothing in it needs a correction"
    return ""


def errata_of(paper: str, formula: Formula) -> tuple[Erratum, ...]:
    """The errata that change the number of a printed form."""
    ledger = next(p for p in papers() if p.key == paper)
    return tuple(e for e in ledger.errata if e.id in formula.errata)


def rows_of_corrected(paper: str, formula: Formula) -> tuple[str, ...]:
    """The rows of the corrected form of a printed equation that has errata."""
    if not formula.errata:
        return ()
    forms = declared()[paper].of(formula.equation) if formula.equation else ()
    return tuple(row for one in forms if one.form is Form.CORRECTED for row in one.rows)


@cache
def safe_sides() -> dict[str, Safe]:
    """The safe side of each row that is evidence of a formula with one."""
    return {
        row: formula.safe
        for paper in declared().values()
        for formula in paper.formulas if formula.safe is not Safe.NEITHER
        for row in formula.rows
    }  # fmt: skip
