"""A printed number whose meaning is searched for: formula, inputs, and readings."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from verify.papers.ledger import erratum, published
from verify.studies.readings.search import Formula, Inputs, Outcome, Reading, search, together


@dataclass(frozen=True, kw_only=True)
class Problem:
    """A number of a paper that its formula does not give with the first reading.

    `reference` is the printed value or the erratum ("paper:id"). For an erratum of a formula,
    `derived` is the result in `unit`, with its certain digits, that follows from an equilibrium or
    from the geometry; the readings are then applied to the printed formula. `errata` are the
    identifiers of readings in the ledger. Inputs that the authors chose are exact; inputs that they
    computed or measured have the rounding errors `rounding`. If `parts` is given, the same readings
    must give the numbers of all parts.
    """

    reference: str
    case: str
    formula: Formula
    inputs: Callable[[], Inputs]
    readings: Callable[[], tuple[Reading, ...]]
    what: str
    derived: str = ""
    unit: str = ""
    rounding: Mapping[str, float] = field(default_factory=dict)
    errata: tuple[str, ...] = ()
    most: int = 2
    parts: "tuple[Problem, ...]" = ()

    @property
    def printed(self) -> str:
        """The printed digits of the number; for several parts, those of all parts."""
        if self.parts:
            return ", ".join(part.printed for part in self.parts)
        return self.derived or published(self.reference).printed

    @property
    def place(self) -> str:
        """Place of the number in the paper."""
        if self.derived or self.parts:
            return erratum(self.reference).place
        return published(self.reference).place

    @property
    def printed_unit(self) -> str:
        if self.parts:
            return self.parts[0].printed_unit
        return self.unit if self.derived else published(self.reference).unit

    def search(self, most: int = 0) -> Outcome:
        """Result of the search over all combinations of at most `most` readings.

        0 selects the default number of readings of the problem.
        """
        if self.parts:
            return together([part.search(most or self.most) for part in self.parts])
        return search(
            self.formula, self.inputs(), self.printed, self.readings(), rounding=self.rounding,
            most=most or self.most, digits=not self.derived,
        )  # fmt: skip
