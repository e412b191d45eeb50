"""A user's description of a rotor: shafts, segments, discs, bearings, links and unbalances.

Nodes are the ends of the segments. They are numbered from 1 along the first shaft, and then
onwards along the next shaft.
"""

from collections.abc import Sequence

from verify.core.inputs import EntryError, Inputs, count, quantity, text


class ShaftInputs(Inputs):
    """Inputs of a shaft, identified by its name."""

    name: str = text("shaft", "name, used by segments to refer to the shaft")
    ratio: float = quantity(
        1.0, "1", "q", "speed over that of the first shaft; negative for the opposite sense of "
                       "rotation", omitted=1.0,
        ge=-100, le=100,
    )  # fmt: skip
    start: float = quantity("0 mm", "mm", "z_0", "axial position of its first node", omitted=0.0)


class SegmentInputs(Inputs):
    """Inputs of a tube of constant section."""

    shaft: str = text("shaft", "name of the shaft; segments of a shaft follow each other")
    length: float = quantity("100 mm", "mm", "l", "length", gt=0, le=1e5)
    d_o: float = quantity("40 mm", "mm", "d_o", "outer diameter", gt=0, le=1e4)
    d_i: float = quantity("0 mm", "mm", "d_i", "bore", omitted=0.0, ge=0, le=1e4)
    E: float = quantity("210 GPa", "GPa", "E", "Young's modulus", omitted=210e9, gt=0, le=1e5)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", omitted=0.3, ge=0, le=0.5)
    rho: float = quantity("7850 kg/m^3", "kg/m^3", "ρ", "density", omitted=7850.0, gt=0, le=1e5)


class NodeInputs(Inputs):
    """Inputs that all elements at a node have."""

    node: int = count(1, "", "node", ge=1, le=10_000)


class BetweenInputs(NodeInputs):
    """Inputs that all elements between two nodes have."""

    to: int = count(2, "", "node on the other shaft", ge=1, le=10_000)


class DiscInputs(NodeInputs):
    """Inputs of a rigid disc at a node; omitted mass and moments are those of a cylinder."""

    mass: float | None = quantity(
        None, "kg", "m", "mass", omitted=None, example="5 kg", ge=0, le=1e6
    )
    polar: float | None = quantity(
        None,
        "kg m^2",
        "I_p",
        "polar moment of inertia",
        omitted=None,
        example="0.03 kg m^2",
        ge=0,
        le=1e6,
    )
    diametral: float | None = quantity(
        None, "kg m^2", "I_d", "diametral moment of inertia",
        omitted=None, example="0.017 kg m^2", ge=0,
        le=1e6,
    )  # fmt: skip
    d_o: float | None = quantity(
        None, "mm", "d_o", "outer diameter, for a cylindrical disc",
        omitted=None, example="200 mm", gt=0,
        le=1e5,
    )  # fmt: skip
    d_i: float = quantity(
        "0 mm", "mm", "d_i", "bore, for a cylindrical disc", omitted=0.0, ge=0, le=1e5
    )
    width: float | None = quantity(
        None, "mm", "b", "width, for a cylindrical disc with the node in its middle",
        omitted=None, example="20 mm", gt=0,
        le=1e5,
    )  # fmt: skip
    rho: float = quantity("7850 kg/m^3", "kg/m^3", "ρ", "density", omitted=7850.0, gt=0, le=1e5)


class SpringInputs(Inputs):
    """Inputs of a bearing's stiffness and damping; if omitted, k_yy is k and c_yy is c."""

    k: float = quantity("100 N/µm", "N/µm", "k", "radial stiffness", ge=0, le=1e9)
    kyy: float | None = quantity(
        None, "N/µm", "k_yy", "stiffness along y, if different from k", omitted=None,
        example="100 N/µm", ge=0, le=1e9,
    )  # fmt: skip
    kxy: float = quantity(
        "0 N/µm", "N/µm", "k_xy", "coupling of x and y", omitted=0.0, ge=-1e9, le=1e9
    )
    c: float = quantity("0 N s/m", "N s/m", "c", "damping", omitted=0.0, ge=0, le=1e12)
    cyy: float | None = quantity(
        None, "N s/m", "c_yy", "damping along y, if different from c", omitted=None,
        example="500 N s/m", ge=0, le=1e12,
    )  # fmt: skip
    k_tilt: float = quantity(
        "0 N m/rad", "N m/rad", "k_φ", "tilting stiffness", omitted=0.0, ge=0, le=1e15
    )
    c_tilt: float = quantity(
        "0 N m s/rad", "N m s/rad", "c_φ", "damping of tilting", omitted=0.0, ge=0, le=1e12
    )
    k_turn: float = quantity(
        "0 N m/rad", "N m/rad", "k_z", "torsional stiffness", omitted=0.0, ge=0, le=1e15
    )


class SupportInputs(SpringInputs, NodeInputs):
    """Inputs of a bearing to the ground."""


class LinkInputs(SpringInputs, BetweenInputs):
    """Inputs of a bearing or a clutch between two shafts."""


class UnbalanceInputs(NodeInputs):
    """Inputs of an unbalance at a node: mass times eccentricity."""

    value: float = quantity("50 g mm", "g mm", "U", "mass times eccentricity", gt=0, le=1e9)
    angle: float = quantity(
        "0 deg", "deg", "α", "angle of the unbalance", omitted=0.0, ge=-360, le=360
    )


def check_shafts(shafts: Sequence[ShaftInputs], segments: Sequence[SegmentInputs]) -> None:
    """Raise EntryError for repeated names, unknown shafts or shafts without segments.

    Raises ValueError if there is no shaft or no segment.
    """
    if not shafts or not segments:
        raise ValueError("a rotor must have at least one shaft with one segment")
    names = [shaft.name for shaft in shafts]
    for k, name in enumerate(names, start=1):
        if name in names[: k - 1]:
            raise EntryError("shafts", k, f"name = {name}", "two shafts have this name: rename one")
    for k, segment in enumerate(segments, start=1):
        if segment.shaft not in names:
            known = ", ".join(names)
            raise EntryError(
                "segments",
                k,
                f"shaft = {segment.shaft}",
                f"no shaft has this name; the shafts are {known}",
            )
        if not segment.d_i < segment.d_o:
            given = f"d_i = {segment.d_i * 1e3:g} mm"
            raise EntryError("segments", k, given, f"must be below d_o = {segment.d_o * 1e3:g} mm")
    if shafts and shafts[0].ratio != 1:
        raise EntryError(
            "shafts", 1, f"ratio = {shafts[0].ratio:g}",
            "must be 1 for the first shaft, because speeds of the rotor are speeds of this shaft",
        )  # fmt: skip
    for k, name in enumerate(names, start=1):
        if name not in [segment.shaft for segment in segments]:
            raise EntryError("shafts", k, "", f"shaft {name} must have at least one segment")


def check_nodes(
    nodes: int, **tables: Sequence[DiscInputs | SpringInputs | UnbalanceInputs]
) -> None:
    """Raise EntryError if an entry refers to a node that does not exist."""
    for table, entries in tables.items():
        for k, entry in enumerate(entries, start=1):
            for key in ("node", "to"):
                node = getattr(entry, key, 1)
                if node > nodes:
                    raise EntryError(table, k, f"{key} = {node}", f"the nodes are 1 to {nodes}")
