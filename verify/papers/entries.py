"""Entries of the file of a paper: printed values, numbered equations and errata, validated."""

import math
from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, StringConstraints, model_validator

from verify.papers.digits import half_last_digit, number

Words = Annotated[str, StringConstraints(min_length=1, strip_whitespace=True)]
Key = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9][A-Za-z0-9-]*$")]


class Entry(BaseModel):
    """Base class of the entries in the file of a paper: immutable, without unknown keys."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class Value(Entry):
    """A printed number: an input, a result, a claim or a limit of the paper's work."""

    id: Key
    what: Words
    symbol: str = ""
    printed: Words
    value: float
    unit: Words
    kind: Literal["theory", "FEA", "test", "standard"]
    role: Literal["input", "result", "claim", "limit"]
    place: Words
    also: tuple[Words, ...] = ()
    approximate: bool = False  # "about", "close to", a bound: the last digit has no meaning
    note: str = ""

    @property
    def standard_uncertainty(self) -> float | None:
        """Half a unit of the last printed place, divided by √3, in `unit`; None if approximate."""
        return None if self.approximate else half_last_digit(self.printed) / math.sqrt(3)

    @model_validator(mode="after")
    def _value_is_what_is_printed(self) -> Self:
        if not math.isclose(number(self.printed), self.value, rel_tol=1e-12, abs_tol=0.0):
            raise ValueError(
                f"{self.id}: value {self.value!r} must equal the printed number {self.printed!r}"
            )
        return self


def literal(printed: str, what: str, place: str) -> Value:
    """Printed number with unit from a source outside the suite, such as "77.25 MPa"."""
    digits, _, unit = printed.partition(" ")
    return Value(
        id="printed", what=what, printed=digits, value=number(digits), unit=unit or "1",
        kind="theory", role="result", place=place or "source",
    )  # fmt: skip


class Equation(Entry):
    """A numbered equation: implemented (with code and test), argued (with a note), or missing.

    `tex` is the equation as printed, including mistakes.
    """

    number: int = Field(ge=1)
    what: Words
    tex: Words
    status: Literal["implemented", "argued", "missing"]
    code: str = ""
    test: str = ""
    note: str = ""

    @model_validator(mode="after")
    def _claims_are_backed(self) -> Self:
        if self.status == "implemented" and not (self.code and self.test):
            raise ValueError(f"equation {self.number}: status 'implemented' requires code and test")
        if self.status == "argued" and not self.note:
            raise ValueError(f"equation {self.number}: status 'argued' requires a reason in note")
        if self.status == "missing" and (self.code or self.test):
            raise ValueError(f"equation {self.number}: status 'missing' excludes code and test")
        return self


class Erratum(Entry):
    """A printed statement that is wrong, its corrected form, and the evidence.

    `printed_tex` and `right_tex` are the equations that belong to the texts `printed` and `right`.
    `values` are the ids of affected printed values of the same paper.
    """

    id: Key
    place: Words
    printed: Words
    printed_tex: str = ""
    right: Words
    right_tex: str = ""
    evidence: Words
    test: str = ""  # empty: no case shows it yet
    values: tuple[Key, ...] = ()
