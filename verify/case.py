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

`freewheel new-case my_rod.py` writes a complete example, `freewheel verify my_rod.py` runs it;
docs/own_case.md is the guide. help(verify.case.given) lists the arguments of a name.

The class
    Case            base class of every case, with all attributes and methods
    given           an input with its unit; count: a whole number; word: one of a few words;
                    text: a name; table: a list of sets of inputs
    Quantity        a formula: decorator of a method that returns SI units
    shared          a value that several formulas read, computed once: decorator of a method
    solved          the numbers of the reference on one mesh; Level is its type
    Scan            a region of inputs in which sweeps compute the errors of the formulas
    CaseError       error for a broken rule, with file, line, quantity and rule

Comparisons of a quantity with the reference; all of them take the arguments in Options
    identity        formula and reference solve the same problem
    approximation   the formula neglects an effect; the kind of its error is one of: Expected (in an
                    interval), about (a value), Computed (when the row is judged), underived (only
                    displayed)
    limit           the error tends to zero with a parameter; over_family: points for the fit
    as_printed      the source prints a number that it computed by the formula
    State           another state of the formulas, such as another load or another size
    errors_of       mesh sizes and errors, for an order of convergence (verify.judging.checks.Order)
Other comparisons
    balance         an equilibrium or energy balance of the reference, satisfied to round-off
    fact            a statement that holds if its margin exceeds the uncertainty of the margin
    Comparison      any check of verify.judging with the quantity that it judges

Figures, in addition to the convergence plots
    AlongLine       a formula and the reference along a line
    Overlay         formulas and the reference over a parameter
    Drawn           any other figure, made from all results; drawn_by: method for all figures;
                    converged: a figure that requires enough levels for an uncertainty
    plane_field     a field of a plane solution; picture: a picture of a field in colours
    sketches        module with shapes for sketches
    plots           module with curves for figures
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
