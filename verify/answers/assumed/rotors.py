"""Assumed inputs of a rotor."""

from typing import Any

from verify.answers.assumed.rules import Assumption, Given


def one_shaft(g: Given) -> list[dict[str, Any]]:
    """Table `shafts` with the only shaft that the segments name.

    Raises ValueError if the segments name several shafts.
    """
    names = list(dict.fromkeys(str(segment["shaft"]) for segment in g.segments))
    if len(names) != 1:
        raise ValueError(
            "the segments name several shafts: add [[inputs.shafts]] with their speed ratios"
        )
    return [{"name": names[0], "ratio": 1.0}]


def unbalanced_node(g: Given) -> int:
    """Node of the first unbalance; without unbalances, node of the first disc or node 1."""
    for table in ("unbalances", "discs"):
        if entries := g.get(table):
            return int(entries[0]["node"])
    return 1


ROTOR_SYSTEM = (
    Assumption(name="shafts", value=one_shaft,
               source="all segments name one shaft, which rotates at the speed n",
               varied=False),
    Assumption(name="speed_from", value=lambda g: 0.9 * g.speed_to,
               source="0.9 of the highest operating speed; run-up passes lower critical speeds"),
    Assumption(name="speed", value=lambda g: g.speed_to, source="the highest operating speed"),
    Assumption(name="margin", value=0.15, usual=(0.1, 0.2),
               source="typical: separation of critical speeds of 10 to 20 % of the operating "
               "speeds"),
    Assumption(name="probe", value=unbalanced_node,
               source="the node of the first unbalance, or of the first disc without one",
               varied=False),
)  # fmt: skip
