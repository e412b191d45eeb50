"""A user's case: one class with inputs, formulas, a reference and comparisons.

    import verify.case as vc

    class Rod(vc.Case):
        '''A rod in tension.'''

        title = "Rod"
        d: float = vc.given("10 mm", "mm", "d", "diameter", gt=0)
        F: float = vc.given("1 kN", "kN", "F", "force")

        @vc.Quantity("σ", "MPa", "stress", equation="1")
        def sigma(self) -> float:
            return self.F / (pi * self.d**2 / 4)

        def reference(self, level: int) -> vc.Level:
            ...                                         # finite elements of a level, coarse to fine
            return vc.solved(1 / level, sigma=force / area)

        def comparisons(self):
            yield vc.identity(Rod.sigma, order=2)

`freewheel new-case my_rod.py` writes such a file that runs, `freewheel verify my_rod.py` runs it;
docs/own_case.md is the guide. help(verify.case.given), and so on, has the arguments of a name.

The class
    Case            base of every case: its attributes and methods, and what may be left out
    given           an input with its unit; count: a whole number; word: one of a few words;
                    text: a name; table: a list of such sets of inputs
    Quantity        a formula, as decorator of a method that returns SI units
    shared          what several formulas read, computed once
    solved          the numbers of the reference on one mesh; Level is its type
    Scan            a region over which sweeps measure the formulas
    CaseError       a broken rule, with file, line, quantity and rule

Comparisons of a quantity with the reference; Options are the arguments that they all take
    identity        both solve one problem
    approximation   the formula neglects an effect: its error is Expected, about a value, Computed
                    where it is judged, or underived
    limit           the error vanishes with a parameter; over_family: its points
    as_printed      a number that the source prints
    State           the same formula under another load, at another size
    errors_of       mesh sizes and errors, for an order of convergence (verify.judging.checks.Order)
Other comparisons
    balance         an equilibrium or energy of the reference, to round-off
    fact            a statement whose margin exceeds its uncertainty
    Comparison      any check of verify.judging with the quantity that it judges

Figures, beside those of convergence
    AlongLine       a formula and the reference along a line
    Overlay         formulas and the reference over a family of cases
    Drawn           any other figure, from all results; drawn_by: all figures of a case so;
                    converged: one where the reference has levels enough
    plane_field     a field of a plane solution; picture: its colours
    sketches        the module of shapes of sketches
    plots           the module of curves
"""

from verify.core.case import FemResult
from verify.core.case import Scan as Scan
from verify.core.inputs import count as count
from verify.core.inputs import quantity
from verify.core.inputs import table as table
from verify.core.inputs import text as text
from verify.core.inputs import word as word
from verify.form import plots as plots
from verify.form import sketches as sketches
from verify.form.case import Case as Case
from verify.form.case import solved as solved
from verify.form.comparisons import Comparison as Comparison
from verify.form.comparisons import Computed as Computed
from verify.form.comparisons import Expected as Expected
from verify.form.comparisons import Options as Options
from verify.form.comparisons import State as State
from verify.form.comparisons import about as about
from verify.form.comparisons import approximation as approximation
from verify.form.comparisons import as_printed as as_printed
from verify.form.comparisons import balance as balance
from verify.form.comparisons import errors_of as errors_of
from verify.form.comparisons import fact as fact
from verify.form.comparisons import identity as identity
from verify.form.comparisons import limit as limit
from verify.form.comparisons import over_family as over_family
from verify.form.comparisons import underived as underived
from verify.form.fields import picture as picture
from verify.form.fields import plane_field as plane_field
from verify.form.figures import AlongLine as AlongLine
from verify.form.figures import Drawn as Drawn
from verify.form.figures import Overlay as Overlay
from verify.form.figures import converged as converged
from verify.form.figures import drawn_by as drawn_by
from verify.form.quantity import CaseError as CaseError
from verify.form.quantity import Quantity as Quantity
from verify.form.quantity import shared as shared

Level = FemResult
given = quantity
