"""Mesh of a wedged roller and its race."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

    from fem.contact.wedged import Geometry

ZONE = 1.15  # half-width of the fine cells over Hertz's


def fem_mesh(geometry: "Geometry", cells: int) -> "Mesh2D":
    """Mesh of half a roller and the race, with `cells` on the half-width."""
    from meshes.contact.block import full_block
    from meshes.contact.tilted import placed, tilted_half_disc
    from meshes.join import join

    R, half = geometry.R, geometry.half
    fine: dict[str, Any] = {"zone": ZONE * geometry.a, "cells": round(ZONE * cells), "refine": 1}
    x, y = R * geometry.normal
    race = full_block(width=R, depth=R, above=True, **fine)
    return join({
        "roller": tilted_half_disc(R=R, tilt=half, **fine),
        "race": placed(race, turn=-half, shift=(float(x), float(y))),
    })  # fmt: skip
