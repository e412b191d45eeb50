"""What the five papers print: values, numbered equations and errata, as validated data.

Each paper is one TOML file beside this module. A value keeps the string that was printed,
because its last digit is the only uncertainty that a printed number carries.
"""

import math
import re
import tomllib
from functools import cache
from pathlib import Path
from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, StringConstraints, model_validator

HERE = Path(__file__).parent
NUMBERED_EQUATIONS = {
    "huang2018": 22,
    "huang2022": 11,
    "nagler2021": 10,
    "wang2023": 13,
    "belcin": 21,
}

Words = Annotated[str, StringConstraints(min_length=1, strip_whitespace=True)]
Key = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9][A-Za-z0-9-]*$")]


class Entry(BaseModel):
    """Base of what a paper's file holds: nothing unknown, nothing changed."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class Value(Entry):
    """A printed number that states an input, a result, a claim or a limit of the paper's work."""

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
    approximate: bool = False  # "about", "close to", a bound: the last digit says nothing
    note: str = ""

    @property
    def standard_uncertainty(self) -> float | None:
        """Half the last printed digit over root three [unit]; None where it is only about so."""
        return None if self.approximate else half_last_digit(self.printed) / math.sqrt(3)

    @model_validator(mode="after")
    def _value_is_what_is_printed(self) -> Self:
        if not math.isclose(number(self.printed), self.value, rel_tol=1e-12, abs_tol=0.0):
            raise ValueError(f"{self.id}: value {self.value!r} is not the printed {self.printed!r}")
        return self


class Equation(Entry):
    """A numbered equation: implemented (code, and a check that it breaks), argued or missing."""

    number: int = Field(ge=1)
    what: Words
    status: Literal["implemented", "argued", "missing"]
    code: str = ""
    test: str = ""
    note: str = ""

    @model_validator(mode="after")
    def _claims_are_backed(self) -> Self:
        if self.status == "implemented" and not (self.code and self.test):
            raise ValueError(f"equation {self.number} is implemented: name its code and its test")
        if self.status == "argued" and not self.note:
            raise ValueError(f"equation {self.number} is argued: give the argument in its note")
        if self.status == "missing" and (self.code or self.test):
            raise ValueError(f"equation {self.number} is missing, yet names code or a test")
        return self


class Erratum(Entry):
    """Something printed that cannot be right, its right form, and the evidence."""

    id: Key
    place: Words
    printed: Words
    right: Words
    evidence: Words
    test: str = ""  # empty: no case shows it yet


class Paper(Entry):
    """One paper with all of its entries."""

    key: Key
    authors: Words
    title: Words
    source: Words
    year: int | None = None
    doi: str = ""
    values: tuple[Value, ...]
    equations: tuple[Equation, ...]
    errata: tuple[Erratum, ...]

    @model_validator(mode="after")
    def _ids_are_unique_and_equations_complete(self) -> Self:
        for name, entries in (("value", self.values), ("erratum", self.errata)):
            ids = [entry.id for entry in entries]
            if twice := sorted({i for i in ids if ids.count(i) > 1}):
                raise ValueError(f"{self.key}: {name} id {', '.join(twice)} is used twice")
        found = [equation.number for equation in self.equations]
        if found != list(range(1, NUMBERED_EQUATIONS[self.key] + 1)):
            raise ValueError(
                f"{self.key}: needs Eqs. 1 to {NUMBERED_EQUATIONS[self.key]} in order, has {found}"
            )
        return self


@cache
def papers() -> tuple[Paper, ...]:
    """All papers, in the order of `NUMBERED_EQUATIONS`."""
    return tuple(
        Paper.model_validate(tomllib.loads((HERE / f"{key}.toml").read_text("utf-8")))
        for key in NUMBERED_EQUATIONS
    )


@cache
def _index() -> dict[str, Value]:
    return {f"{paper.key}:{value.id}": value for paper in papers() for value in paper.values}


def published(reference: str) -> Value:
    """The value named `paper:id`, such as "wang2023:k1-theory"; KeyError where there is none."""
    return _index()[reference]


def erratum(reference: str) -> Erratum:
    """The erratum named `paper:id`; KeyError where there is none."""
    found = {f"{paper.key}:{e.id}": e for paper in papers() for e in paper.errata}
    return found[reference]


_NUMBER = re.compile(
    r"(?P<sign>[-+−]?)(?P<mantissa>\d+(?:\.\d+)?)(?:(?:e|\s*[×x]\s*10\^?)(?P<exponent>[-+−]?\d+))?"
)


def _parts(printed: str) -> tuple[str, int]:
    match = _NUMBER.fullmatch(printed.strip())
    if match is None:
        raise ValueError(f"{printed!r} is not a printed number such as 0.601 or 1.4×10^-5")
    sign = "-" if match["sign"] in ("-", "−") else ""
    exponent = int((match["exponent"] or "0").replace("−", "-"))
    return sign + match["mantissa"], exponent


def number(printed: str) -> float:
    """The number that a printed string means.

    >>> number("1.4×10^-5")
    1.4e-05
    """
    mantissa, exponent = _parts(printed)
    return float(f"{mantissa}e{exponent}")


def half_last_digit(printed: str) -> float:
    """Half a unit in the last printed place.

    >>> half_last_digit("0.613"), half_last_digit("3500")
    (0.0005, 0.5)
    """
    mantissa, exponent = _parts(printed)
    decimals = len(mantissa.partition(".")[2])
    return float(f"0.5e{exponent - decimals}")
