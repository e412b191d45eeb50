"""Command line of `freewheel design`, for springs and for sprags."""

from pathlib import Path
from typing import Literal

from verify.app.arguments import Number


def design(
    file: Path,
    /,
    *,
    choose: Number | None = None,
    fem: bool = True,
    json: bool = False,
    out: Path | None = None,
    units: Literal["si", "mm", "inch"] | None = None,
) -> int:
    """Find the accordion springs for a task, or the sprag crown with the lowest pressure.

    Parameters
    ----------
    file
        Task (TOML) written by `freewheel init design-spring` or `freewheel init design-sprag`, or a
        parameter file of sprag-clutch.
    choose
        For springs: number of the member of the Pareto front to select. The default is the member
        closest to the ideal point among those that finite elements confirm.
    fem
        Verify every member of the Pareto front by finite elements, or the crown by a half-space.
    json
        Print JSON instead of text.
    out
        Folder for the page, all candidates and a parameter file of the selected design.
    units
        Units of the answer: si, mm (mm, N, MPa) or inch; by default the units of the file. Files of
        `--out` and the pressure table of a crown are always in mm, N and MPa.
    """
    from verify.core.inputs import read_parameter_file

    case, _, _ = read_parameter_file(file)
    if case in ("design-sprag", "sprag-clutch"):
        from verify.app.design_sprag.command import run_design as run_sprag

        return run_sprag(file, choose=choose, use_fem=fem, as_json=json, out=out, units=units)
    from verify.app.design.command import run_design

    return run_design(file, choose=choose, use_fem=fem, as_json=json, out=out, units=units)
