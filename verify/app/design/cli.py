"""How `freewheel design` is called, for springs and for sprags."""

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
    """Find the accordion springs that do a task, or the crown of a sprag with the least pressure.

    Parameters
    ----------
    file
        The task (TOML), see `freewheel init design-spring` and `freewheel init design-sprag`; a
        file of sprag-clutch does as well.
    choose
        Of springs, the member of the front to go on with; by default the one nearest to the best
        of everything that finite elements keep.
    fem
        Set finite elements beside every member of the front, a half-space beside the crown.
    json
        Print JSON instead of text.
    out
        Folder for the page, all candidates and a parameter file of what is chosen.
    units
        Units of the answer: si, mm (mm, N, MPa) or inch; by default those of the file. Files of
        `--out` and the table of a crown's pressures stay in mm, N and MPa.
    """
    from verify.core.inputs import read_parameter_file

    case, _, _ = read_parameter_file(file)
    if case in ("design-sprag", "sprag-clutch"):
        from verify.app.design_sprag.command import run_design as run_sprag

        return run_sprag(file, choose=choose, use_fem=fem, as_json=json, out=out, units=units)
    from verify.app.design.command import run_design

    return run_design(file, choose=choose, use_fem=fem, as_json=json, out=out, units=units)
