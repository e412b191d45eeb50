"""All numbers whose meaning is searched for, and numbers for which a search is impossible."""

from verify.studies.readings.of_freewheels import PROBLEMS as FREEWHEELS
from verify.studies.readings.of_sprags import PROBLEMS as SPRAGS
from verify.studies.readings.of_springs import PROBLEMS as SPRINGS
from verify.studies.readings.problem import Problem

PROBLEMS: tuple[Problem, ...] = (*SPRAGS, *FREEWHEELS, *SPRINGS)

# not reproduced, and no formula of the paper gives them
WITHOUT_FORMULA = {
    "huang2018:table1-i-1": "an inertia that no equation contains",
    "huang2018:table1-c-f": "a torque that no equation contains",
    "huang2018:stress-25nm-unmodified": "the end pressure of an uncrowned roller has no limit: it "
    "depends on the number of slices, which is fitted",
    "nagler2021:friction-ratio-red-yellow": "a limit that was found in tests",
    "nagler2021:friction-ratio-yellow-green": "a limit that was found in tests",
    "nagler2021:rig-torsion-angle": "a limit of the test rig",
    "nagler2021:rig-axial-displacement": "a limit of the test rig",
    "nagler2021:test-runs-per-clutch": "a number of tests",
    "wang2023:yield-strength": "a property of a material that the paper does not name",
    "wang2023:rule-length-thickness-max": "a rule, which the paper's spring violates",
    "wang2023:rule-displacement-ratio-max": "a rule, which the paper's tests violate",
    "huang2022:unbalance-1-node": "a node number that the text contradicts",
}
