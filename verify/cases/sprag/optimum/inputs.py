"""Inputs of the search for the optimal crown: sprag clutch, given crown, bounds, search.

The default given crowns are those that the paper prints as optimal (Eqs. 21, 22).
"""

from pydantic import model_validator

from analytic.surrogate.box import Box
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.inputs import count, quantity

MOST_DESIGNS = 7  # levels: 343 designs take half a minute


class OptimumInputs(EngagementInputs):
    """Inputs of a clutch whose crown is optimised within bounds (Eq. 19) under a torque."""

    K_1_low: float = quantity(1.0, "1", "K_1,min", "lower bound of K_1", omitted=1.0,
                              gt=0, le=100, claims="huang2018:k1-lower-bound")  # fmt: skip
    K_1_high: float = quantity(5.0, "1", "K_1,max", "upper bound of K_1", omitted=5.0,
                               gt=0, le=100, claims="huang2018:k1-upper-bound")  # fmt: skip
    K_2_low: float = quantity(0.4, "1", "K_2,min", "lower bound of K_2", omitted=0.4,
                              gt=0, le=1, claims="huang2018:k2-lower-bound")  # fmt: skip
    K_2_high: float = quantity(0.7, "1", "K_2,max", "upper bound of K_2", omitted=0.7,
                               gt=0, le=1, claims="huang2018:k2-upper-bound")  # fmt: skip
    z_m_low: float = quantity("0.005 mm", "mm", "z_m,min", "lower bound of z_m",
                              omitted=5e-6, gt=0, le=10,
                              claims="huang2018:zm-lower-bound")  # fmt: skip
    z_m_high: float = quantity("0.025 mm", "mm", "z_m,max", "upper bound of z_m",
                               omitted=25e-6, gt=0, le=10,
                               claims="huang2018:zm-upper-bound")  # fmt: skip
    levels: int = count(5, "", "levels of each parameter in the factorial", ge=4, le=MOST_DESIGNS,
                        claims="huang2018:factorial-levels")  # fmt: skip
    extra: int = count(10, "", "number of random designs that test the surrogate", ge=3, le=200,
                       claims="huang2018:validation-points")  # fmt: skip
    population: int = count(500, "", "population of the genetic algorithm", ge=10, le=5000,
                            claims="huang2018:ga-population")  # fmt: skip
    generations: int = count(100, "", "generations of the genetic algorithm", ge=2, le=1000,
                             claims="huang2018:ga-generations")  # fmt: skip
    crossover: float = quantity(0.9, "1", "", "probability of crossover", omitted=0.9, ge=0,
                                le=1, claims="huang2018:ga-crossover")  # fmt: skip
    mutation: float = quantity(0.01, "1", "", "probability of mutation of a bit",
                               omitted=0.01, ge=0, le=1,
                               claims="huang2018:ga-mutation")  # fmt: skip
    T_less: float | None = quantity(None, "N m", "T'", "second torque; the optimal crowns for "
                                    "both torques are compared", omitted=None, gt=0, le=1e9,
                                    example="15 N m")  # fmt: skip

    @model_validator(mode="after")
    def _searched(self) -> "OptimumInputs":
        for low, high, unit, factor in (
            ("K_1_low", "K_1_high", "", 1), ("K_2_low", "K_2_high", "", 1),
            ("z_m_low", "z_m_high", " mm", 1e3),
        ):  # fmt: skip
            a, b = getattr(self, low), getattr(self, high)
            if not a < b:
                raise ValueError(
                    f"the lower bound must be below the upper bound: {low} < {high}, got "
                    f"{low} = {a * factor:g}{unit}, {high} = {b * factor:g}{unit}"
                )
        if self.population % 2:
            raise ValueError(
                "the number of individuals in the population must be even, got population = "
                f"{self.population}"
            )
        return self

    @property
    def box(self) -> Box:
        """Bounds of K_1, K_2, z_m [m] (Eq. 19)."""
        return Box(
            (self.K_1_low, self.K_2_low, self.z_m_low),
            (self.K_1_high, self.K_2_high, self.z_m_high),
        )

    @property
    def torques(self) -> tuple[float, ...]:
        """The torque [N m], and the second torque, if any."""
        return (self.T,) if self.T_less is None else (self.T, self.T_less)


class Optimum25Inputs(OptimumInputs):
    """Inputs for 25 N m, with the crown of Eq. 21."""

    K_1: float = quantity(2.1507, "1", "K_1", "depth factor of the given crown", gt=0, le=100,
                          claims="huang2018:optimum-25nm-k1")  # fmt: skip
    K_2: float = quantity(0.6763, "1", "K_2", "crowned fraction of the length of the given crown",
                          gt=0, le=1, claims="huang2018:optimum-25nm-k2")  # fmt: skip
    z_m: float = quantity("0.0121 mm", "mm", "z_m", "drop at the ends of the given crown",
                          gt=0, le=10, claims="huang2018:optimum-25nm-zm")  # fmt: skip


class Optimum40Inputs(OptimumInputs):
    """Inputs for 40 N m, with the crown of Eq. 22; the second torque is 25 N m."""

    T: float = quantity("40 N m", "N m", "T", "torque in the locking direction", gt=0, le=1e9,
                        claims="huang2018:torque-40")  # fmt: skip
    K_1: float = quantity(2.8, "1", "K_1", "depth factor of the given crown", gt=0, le=100,
                          claims="huang2018:optimum-40nm-k1")  # fmt: skip
    K_2: float = quantity(0.7, "1", "K_2", "crowned fraction of the length of the given crown",
                          gt=0, le=1, claims="huang2018:optimum-40nm-k2")  # fmt: skip
    z_m: float = quantity("0.0118 mm", "mm", "z_m", "drop at the ends of the given crown",
                          gt=0, le=10, claims="huang2018:optimum-40nm-zm")  # fmt: skip
    T_less: float | None = quantity("25 N m", "N m", "T'", "second torque; the optimal crowns for "
                                    "both torques are compared", omitted=None, gt=0, le=1e9,
                                    claims="huang2018:torque-25")  # fmt: skip
