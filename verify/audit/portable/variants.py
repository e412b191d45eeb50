"""Emulated machines: this machine, and variants that differ from it in one respect each."""

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

BASELINE = "baseline"
SEEDS = 10
CORE_TYPE, DISABLED, NUMBA = "OPENBLAS_CORETYPE", "NPY_DISABLE_CPU_FEATURES", "NUMBA_CPU_NAME"
THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
CORES = {  # core type of OpenBLAS, and the instruction set that its kernels require
    "Prescott": "pni",
    "Nehalem": "sse4_2",
    "Sandybridge": "avx",
    "Haswell": "avx2",
    "Zen": "avx2",
    "SkylakeX": "avx512vl",
}

Probe = Callable[[Mapping[str, str]], dict[str, Any]]


@dataclass(frozen=True)
class Variant:
    """One emulated machine: variables of its environment, or a seed that perturbs the inputs."""

    name: str
    what: str
    environment: Mapping[str, str] = field(default_factory=dict)
    seed: int | None = None
    flag: str = ""  # instruction set that the processor must have

    def applied(self, environment: Mapping[str, str]) -> dict[str, str]:
        """`environment` with one BLAS thread and with the variables of this machine."""
        return {**environment, **dict.fromkeys(THREADS, "1"), **self.environment}


@dataclass(frozen=True)
class Machines:
    """Machines to run, settings in effect on each, and reasons why others are not emulated."""

    variants: tuple[Variant, ...]
    effective: Mapping[str, Mapping[str, Any]]
    not_emulated: Mapping[str, str]


def candidates(found: Sequence[str], seeds: int = SEEDS) -> tuple[Variant, ...]:
    """All machines; `found` lists the instruction sets that numpy selects on this machine."""
    return (
        Variant(BASELINE, "this machine, one BLAS thread"),
        Variant("threads-2", "two BLAS threads", dict.fromkeys(THREADS, "2")),
        *(
            Variant(f"core-{core.lower()}", f"OpenBLAS kernels of {core}", {CORE_TYPE: core},
                    flag=flag)
            for core, flag in CORES.items()
        ),
        Variant("numpy-baseline", "numpy without run-time instruction sets",
                {DISABLED: " ".join(found)}),
        Variant("numba-generic", "numba for a generic processor", {NUMBA: "generic"}),
        *(
            Variant(f"perturbed-{seed}", f"inputs perturbed by 1e-13 (seed {seed})", seed=seed)
            for seed in range(1, seeds + 1)
        ),
    )  # fmt: skip


def machines(
    variants: Sequence[Variant],
    probe: Probe,
    flags: frozenset[str],
    environment: Mapping[str, str] | None = None,
) -> Machines:
    """Machines that can be emulated here, selected by the settings that `probe` finds in effect.

    `variants` begins with the baseline. `flags` are the instruction sets of the processor. A
    machine with the same settings in effect as an earlier one is not run again.
    """
    around = os.environ if environment is None else environment
    chosen: list[Variant] = []
    effective: dict[str, Mapping[str, Any]] = {}
    refused: dict[str, str] = {}
    for variant in variants:
        if reason := _missing(variant, flags, around):
            refused[variant.name] = reason
            continue
        if variant.environment or not chosen:
            try:
                effective[variant.name] = probe(variant.applied(around))
            except OSError as error:
                if not chosen:
                    raise
                refused[variant.name] = str(error)
                continue
            equal = [v.name for v in chosen if effective[v.name] == effective[variant.name]]
            if equal:
                refused[variant.name] = f"the same settings are in effect as in {equal[0]}"
                del effective[variant.name]
                continue
        else:
            effective[variant.name] = effective[BASELINE]
        chosen.append(variant)
    return Machines(tuple(chosen), effective, refused)


def _missing(variant: Variant, flags: frozenset[str], environment: Mapping[str, str]) -> str:
    """Reason why the machine cannot be emulated; empty if none is known before its start."""
    for name in variant.environment:
        if name not in THREADS and environment.get(name):
            return f"the environment already sets {name}={environment[name]}"
    if variant.environment.get(DISABLED, "all") == "":
        return "numpy selects no instruction set at run time here"
    if variant.flag and variant.flag not in flags:
        known = f"the processor lacks {variant.flag}"
        return known if flags else "the instruction sets of the processor are unknown"
    return ""
