"""Perturbation of default inputs in the thirteenth digit, as a substitute for another machine.

Because the default inputs of a case are changed, formulas, finite elements and all other code use
the same numbers. These are treated as the inputs of the paper, so that every row is judged.
"""

import zlib
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydantic import ValidationError

from verify.core.inputs import EntryError, Inputs, broken_rule

SIZE = 1e-13  # standard deviation of the relative change of an input


@dataclass(frozen=True)
class Outcome:
    """Result of perturbing the default inputs of one model.

    `fixed` lists numbers that a rule of the model determines; they are not changed. `rejected` is
    the rule that the perturbed values violate together; in this case, no value is changed.
    """

    fixed: tuple[str, ...] = ()
    rejected: str = ""


def perturb_defaults(models: Iterable[type[Inputs]], seed: int) -> dict[type[Inputs], Outcome]:
    """Perturb the default inputs of the models for the rest of this process."""
    return {model: _perturb(model, seed) for model in dict.fromkeys(models)}


def perturbed(
    inputs: Inputs, seed: int, fixed: Collection[str] = (), place: str = ""
) -> dict[str, Any]:
    """Values of the inputs, each number multiplied by 1 + 1e-13 N(0, 1), also in tables.

    Integers, words, omitted inputs and the places in `fixed` ("segments[3].length") are not
    changed. The factor depends only on the seed and on the place.
    """
    return {
        name: _perturbed(getattr(inputs, name), seed, fixed, f"{place}{name}")
        for name in type(inputs).model_fields
    }


def _perturbed(value: Any, seed: int, fixed: Collection[str], place: str) -> Any:
    if isinstance(value, float) and place not in fixed:
        return value * (1.0 + SIZE * _normal(seed, place))
    if isinstance(value, Inputs):
        return perturbed(value, seed, fixed, f"{place}.")
    if isinstance(value, tuple):
        return tuple(
            _perturbed(v, seed, fixed, f"{place}[{k}]") for k, v in enumerate(value, start=1)
        )
    return value


def _normal(seed: int, place: str) -> float:
    """Random number with standard normal distribution, equal on all machines."""
    return float(np.random.default_rng([seed, zlib.crc32(place.encode())]).standard_normal())


def _perturb(model: type[Inputs], seed: int) -> Outcome:
    """Perturb the default inputs of one model, except those that its rules determine."""
    fixed: list[str] = []
    while True:
        try:
            found = model.model_validate(perturbed(model(), seed, fixed))
            break
        except ValidationError as error:
            place = _place(error)
            if not place or place in fixed:
                return Outcome(rejected=broken_rule(model, error, "inputs"))
            fixed.append(place)
    for name, field in model.model_fields.items():
        field.default = getattr(found, name)
    model.model_rebuild(force=True)
    return Outcome(fixed=tuple(fixed))


def _place(error: ValidationError) -> str:
    """Place of the single number that violates a rule, as "segments[3].length"; or empty."""
    fault: Any = error.errors(include_url=False)[0]
    reason = (fault.get("ctx") or {}).get("error")
    if isinstance(reason, EntryError):
        return reason.place.partition(" ")[0]  # "shafts[1].ratio = 1" names the value too
    parts = (f"[{part + 1}]" if isinstance(part, int) else f".{part}" for part in fault["loc"])
    return "".join(parts).removeprefix(".")
