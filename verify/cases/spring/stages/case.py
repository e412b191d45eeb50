"""Accordion spring beyond its free stage: contact of the tips (Wang et al. 2023, Eq. 10)."""

from collections.abc import Iterator
from typing import ClassVar, Self

from verify.case import (
    AlongLine,
    Comparison,
    Drawn,
    Level,
    Quantity,
    Scan,
    State,
    balance,
    errors_of,
    identity,
)
from verify.cases.spring.limits import too_slender
from verify.cases.spring.stages import figures as drawn
from verify.cases.spring.stages import readings as paper
from verify.cases.spring.stages import reference as linked_frame
from verify.cases.spring.stages import sketch as sketched
from verify.cases.spring.stages.ends import ENDS, LATER, Ends
from verify.cases.spring.stages.formulas import StageFormulas
from verify.core.case import Check
from verify.core.figures import Picture
from verify.form.adapter import adapted
from verify.judging.checks import Accepted, Order
from verify.judging.published_checks import PrintedMeasurement

CHORDS = 5e-4, "the only error of the frame is that chords replace the arcs"
SHARED = "beam theory, small displacements, rigid contact without friction"


class StageSpring(StageFormulas):
    """First contact of the free tips with the adjacent leaves (point A), and stiffness beyond it.

    Closed forms are compared with a frame of straight elements, in which rigid links model the
    contacts. Both use linear theory.
    """

    id = "spring-stages"
    title = "Accordion spring beyond its free stage"
    source = "wang2023"
    place = "Sec. 2, Eq. 10; Table 1"
    levels: ClassVar = (4, 8, 16, 32)
    scans: ClassVar = (
        Scan(vary=("n=6,10,14", "b=0.05mm,0.1mm,0.2mm", "alpha=70deg,80deg"), star=True),
    )
    readings: ClassVar = (
        "head and tail are whole leaves: the force acts in the middle of the head leaf; the tail "
        'leaf is clamped in its middle ("at mid-leaf") or along its whole length ("at arc")',
        "r is the inner radius: the centre line of the arcs has the radius r + b/2",
        "the corner of a tip touches the face of the leaf: the gap between the centre lines is "
        "reduced by b/2 of the tip and by b/(2 sin α) of the leaf",
        "the force between tip and leaf acts along the axis, because at A the leaf has rotated "
        "until it is parallel to the tip; a force normal to the unloaded leaf would change U_A "
        'by 1 % and k_2 by 1 % (rows "contact force normal to the leaf")',
        "one reading of supports, radius and strip is chosen only by its k_1; k_2 and point A of "
        "this reading therefore have the status CALIBRATED",
    )
    assumptions: ClassVar = (
        "small displacements, although U_A is half of the free length of the paper's spring",
        "no friction between tip and leaf; no other contacts",
        "bending and axial force; the strip is narrow (E I) unless a width factor is given",
    )

    def reference(self, level: int) -> Level:
        """Reference: frames whose tips are linked to the leaves at the contacts."""
        return linked_frame.solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows: closed forms against the frame; the best reading against Eq. 10.

        The best reading is that with the k_1 nearest to Eq. 10.
        """
        spring = StageSpring
        first = ((spring.k1, "stiffness k_1"), (spring.F_A, "force at point A"),
                 (spring.U_A, "displacement at point A"), (spring.k2, "stiffness k_2"))  # fmt: skip
        second = ((spring.U_B, "displacement at which the second tip touches"),
                  (spring.k3, "stiffness k_3 with both tips in contact"))  # fmt: skip
        for quantities, conditions in ((first, ENDS), (second, LATER)):
            for ends in conditions:
                for q, words in quantities:
                    yield identity(
                        q, state=self._held(ends), name=f"{words}, {ends.words}", order=2,
                        sensitivity=CHORDS, shares=SHARED,
                    )  # fmt: skip
        for ends in ENDS:
            F_A = {f"F_A, {ends.words}": self._spring(ends).F_A}
            yield balance(
                f"push_{ends.key}", f"force of the link that closes at point A, {ends.words}", "C",
                "N", of=F_A, bound=1e-9, because="both lines intersect at A within round-off",
            )  # fmt: skip
        yield Order(name="order of convergence of k_2 by straight elements", symbol="p", unit="1",
                    order=2, errors=errors_of(spring.k2, state=self._held(ENDS[0])))  # fmt: skip
        yield from self._calibrated()
        yield from self._beside_prints()

    def _spring(self, ends: Ends) -> Self:
        return self.model_copy(update=ends._asdict())

    def _held(self, ends: Ends) -> State:
        return State(self._spring(ends), ends.key, ends.words, displayed=False)

    @property
    def _reading(self) -> State:
        """The paper's spring by the reading whose k_1 is nearest to the printed one."""
        x = paper.chosen(self)
        spring = self.model_copy(update={
            "tail": x.tail, "head": x.head, "inner": x.radius == "r", "width_factor": x.factor,
            "theory": "bending",
        })  # fmt: skip
        return State(spring, "reading", "calibrated interpretation of the paper", displayed=False)

    def _calibrated(self) -> Iterator[Comparison]:
        spring = StageSpring
        for q, key, figure, words, printed in (
            (spring.k1, "k1", paper.MET, "k_1", ("wang2023:k1-fea",)),
            (spring.k2, "k2", paper.ACCEPTED, "k_2", ("wang2023:k2-fea",)),
            (spring.U_A, "U", paper.ACCEPTED, "displacement at point A", ()),
            (spring.F_A, "F", paper.ACCEPTED, "force at point A", ()),
        ):
            yield Comparison(quantity=q, state=self._reading, check=Accepted(
                name=f"{words} against Eq. 10, calibrated interpretation of the paper",
                symbol=q.symbol, unit=q.unit, margin=paper.keeps(key, figure), fem_needed=False,
                fitted=paper.FITTED, printed=printed, paper_only=True,
            ))  # fmt: skip

    def _beside_prints(self) -> Iterator[Comparison]:
        spring = StageSpring
        test = "paper's test"
        for q, words, what, printed in (
            (spring.k1, "k_1", test, "k1-test"), (spring.k2, "k_2", test, "k2-test"),
            (spring.intercept, "force at U = 0 on the line of slope k_2", "constant of Eq. 10",
             "eq10-ab-intercept"),
        ):  # fmt: skip
            name = f"{words} against the {what}, calibrated interpretation of the paper"
            yield _beside(q, self._reading, name, printed)
        most = self.widest if self.width_factor is None else self.width_factor
        guided = self.model_copy(update={
            "head": "guided", "tail": "mid-leaf", "width_factor": most, "theory": "bending",
        })  # fmt: skip
        wide = State(guided, "guided_wide", "guided head and wide strip", displayed=False)
        for q in (spring.k1, spring.k2):
            for what, printed in (("paper's shell model", "fea"), (test, "test")):
                name = f"{q.symbol} with a guided head and a wide strip, compared with the {what}"
                yield _beside(q, wide, name, f"{q.name}-{printed}")

    refusal = too_slender

    def figures(self) -> Iterator[AlongLine | Drawn]:
        """Figures of force over displacement: closed form against frame; comparison with Eq. 10."""
        yield drawn.judged(self)
        yield Drawn(drawn.beside)

    def pictures(self) -> Iterator[Picture]:
        """Picture of the bending stress at point A."""
        yield drawn.bending_stress(self)

    tables = paper.tables
    sketch = sketched.sketch


def _beside(q: Quantity, state: State, name: str, printed: str) -> Comparison:
    """Row that compares the formula `q` in a state with a printed measurement."""
    return Comparison(quantity=q, state=state, check=PrintedMeasurement(
        name=name, symbol=q.symbol, unit=q.unit, analytic=f"{q.name}_{state.key}",
        reference=f"wang2023:{printed}",
    ))  # fmt: skip


STAGES = adapted(StageSpring)
