"""Meshes of every element type for the tests of plane bodies, mapped from a grid."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

KINDS = {
    "tri3": (MeshTri1, MeshTri1, 1),
    "tri6": (MeshTri1, MeshTri2, 2),
    "tri6, straight": (MeshTri1, MeshTri1, 2),
    "quad4": (MeshQuad1, MeshQuad1, 1),
    "quad9": (MeshQuad1, MeshQuad2, 2),
    "quad9, straight": (MeshQuad1, MeshQuad1, 2),
}
every_element = pytest.mark.parametrize("kind", ["tri3", "tri6", "quad4", "quad9"])
every_case = pytest.mark.parametrize(
    ("kind", "assumption"),
    [
        ("tri3", "plane strain"),
        ("tri6", "plane stress"),
        ("quad4", "plane stress"),
        ("quad9", "plane strain"),
    ],
)


def degree(kind):
    return KINDS[kind][2]


def mapped(kind, s, t, place=None, names=("left", "right", "bottom", "top"), split=None):
    """The grid s x t put in its `place` (s, t) -> (x, y), its four sides named.

    With `split` also the bodies "west" and "east" of the line s = `split`.
    """
    straight, shape, _ = KINDS[kind]
    grid = straight.init_tensor(np.asarray(s, float), np.asarray(t, float))
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    first, last, below, above = names
    mesh = mesh.with_boundaries({
        first: lambda x: x[0] == s[0],
        last: lambda x: x[0] == s[-1],
        below: lambda x: x[1] == t[0],
        above: lambda x: x[1] == t[-1],
    })  # fmt: skip
    if split is not None:
        mesh = mesh.with_subdomains(
            {"west": lambda x: x[0] < split, "east": lambda x: x[0] > split}
        )
    return mesh if place is None else replace(mesh, doflocs=np.array(place(*mesh.doflocs)))


def ring(kind, r, phi):
    """Cells between the radii `r` and the angles `phi`: "bore", "rim", "first cut", "last cut"."""
    names = ("bore", "rim", "first cut", "last cut")
    return mapped(kind, r, phi, lambda r, phi: (r * np.cos(phi), r * np.sin(phi)), names)


def tube(kind, bore):
    """A tube or a bar of outer radius 2 and length 1: wavy cells within, two bodies."""

    def place(s, t):
        wave = np.sin(np.pi * s) * np.sin(np.pi * t)
        s = s + 0.06 * wave * np.cos(5 * t)
        return bore + (2 - bore) * s, t + 0.08 * np.sin(np.pi * t) * np.cos(4 * s)

    names = ("bore", "rim", "bottom", "top")
    return mapped(kind, np.linspace(0, 1, 7), np.linspace(0, 1, 4), place, names, split=0.5)


def trapezoid(kind):
    """Corners (0, 0), (4, 0), (4, 3), (0, 1); "west" and "east" of x = 1."""
    s, t = np.array([0, 0.25, 0.6, 1]), np.array([0, 0.3, 1])
    return mapped(kind, s, t, lambda s, t: (4 * s, (1 + 2 * s) * t), split=0.25)


def in_plane(material, assumption):
    """E' and nu' of sigma = E' eps along a free strip: plane stress as they are."""
    E, nu = material.E, material.nu
    return (E, nu) if assumption == "plane stress" else (E / (1 - nu**2), nu / (1 - nu))


def order(error, solved, meshes):
    """Observed order of `error` of solutions on meshes, each twice as fine as the one before."""
    errors = [abs(error(solved(n))) for n in meshes]
    return np.log2(errors[0] / errors[-1]) / (len(meshes) - 1)
