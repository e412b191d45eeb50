"""Files of rotors: refused inputs, findings and warnings, output of the command."""

import pytest

from tests.verify.cases.rotor.system_inputs import RAW, built, changed
from verify.cases.rotor.system.case import SYSTEM
from verify.cases.rotor.system.inputs import RPM
from verify.core.inputs import InputError

# What is refused, in one line.


@pytest.mark.parametrize(
    ("raw", "message"),
    [
        (changed("supports", 2, node=31), "inputs.supports[2].node = 31: the nodes are 1 to 14"),
        (changed("links", 1, to=15), "inputs.links[1].to = 15: the nodes are 1 to 14"),
        (changed("segments", 1, d_i="70 mm"),
         "inputs.segments[1].d_i = 70 mm: must be below d_o = 70 mm"),
        (changed("supports", 1, kxy="70 N/µm"), "inputs.supports[1]: kxy must not exceed the"),
        (changed("links", 1, to=5), "inputs.links[1].to = 5: must differ from node"),
        (changed("links", 1, to=3),
         "inputs.links[1].to = 3: node 5 must be on a shaft other than outer: a link joins"),
        (changed("links", 1, k_turn="1 N m/rad"),
         "inputs.links[1].k_turn = 1 N m/rad: shafts outer and inner have different speeds"),
        (changed("segments", 7, shaft="middle"),
         "inputs.segments[7].shaft = middle: no shaft has this name; the shafts are outer, inner"),
        (changed("shafts", 2, name="outer"),
         "inputs.shafts[2].name = outer: two shafts have this name"),
        (changed(shafts=[*RAW["shafts"], {"name": "third"}]),
         "inputs.shafts[3]: shaft third must have at least one segment"),
        (changed(segments=[]), "inputs: a rotor must have at least one shaft with one segment"),
        (changed(segments=RAW["segments"] * 13), "inputs: the segments have 158 nodes; at most"),
        (changed("discs", 4, drop=["width"]),
         "inputs.discs[4]: give either mass, polar and diametral of the disc, or d_o and width"),
        (changed("discs", 4, d_i="220 mm"),
         "inputs.discs[4]: d_i must be below d_o, got d_i = 220 mm, d_o = 220 mm"),
        (changed("discs", 2, node=3, width="230 mm"), "inputs.discs[2]: overlaps discs[1] by 5 mm"),
        (changed("discs", 1, polar="0.0102 kg m^2"),
         "inputs.discs[1].polar = 0.0102 kg m^2: must not exceed twice the "
         "diametral moment, 0.01 kg m^2"),
        (changed(supports=RAW["supports"][1:], links=[]),
         "inputs: the rotor must be supported: shaft outer shifts and tilts freely in x and y"),
        (changed(supports=[], links=[]), "inputs: the rotor must be supported: no bearing"),
        (changed(speed_from="9000 r/min"), "inputs: speed_from must be below speed"),
        (changed(probe=15), "inputs: probe = 15 must be one of the nodes 1 to 14"),
        (changed("shafts", 1, ratio=0.5),
         "inputs.shafts[1].ratio = 0.5: must be 1 for the first shaft, because speeds of"),
    ],
)  # fmt: skip
def test_a_rotor_that_cannot_be_is_refused_in_one_line(raw, message):
    with pytest.raises(InputError) as found:
        built(raw)
    assert str(found.value).startswith(f"r.toml: {message}")
    assert "\n" not in str(found.value)


# Findings and warnings.


def texts_of(raw):
    q = built(raw)
    v = SYSTEM.analytic(q)
    return q, SYSTEM.findings(q, v), SYSTEM.summary(q, v), SYSTEM.warnings(q, v)


def test_the_verdict_is_clear_or_not_and_is_followed_by_the_nearest_critical_speeds():
    q, found, summary, warned = texts_of(RAW)
    below, above = (q.study.excited[k].speeds[j] / RPM for k, j in ((0, 0), (1, 1)))
    assert found[0] == (
        "clear: no critical speed that an unbalance excites is within 15% of the operating range "
        "5600 to 9000 r/min"
    )
    assert (
        f"critical speed {below:.5g} r/min (unbalance of shaft outer, forward whirl): " in found[1]
    )
    assert f"{1 - below / 5600:.1%} below the operating range" in found[1]
    assert (
        f"critical speed {above:.5g} r/min (unbalance of shaft inner, forward whirl): " in found[2]
    )
    assert f"{above / 9000 - 1:.1%} above the operating range" in found[2]
    assert summary["verdict"] == "clear"
    assert not warned
    q, found, summary, _ = texts_of(changed(margin=0.25))
    assert found[0] == (
        "not clear: 2 critical speeds within 25% of the operating range 5600 to 9000 r/min"
    )
    assert summary["verdict"] == "not clear"
    distances = {round(c["speed"]): c["distance"] for c in summary["critical_speeds"]}
    first = q.study.excited[0].speeds[0] / RPM
    assert distances[round(first)] == pytest.approx(first / 5600 - 1)
    _, found, _, _ = texts_of(changed(speed_from="4000 r/min"))
    assert found[0].startswith("not clear: 1 critical speed within")
    assert found[1].endswith("in the operating range")


UNDAMPED = changed(
    links=[RAW["links"][0] | {"c": "0 N s/m"}],
    supports=[s | {"c": "0 N s/m"} for s in RAW["supports"]],
)


@pytest.mark.parametrize(
    ("raw", "words"),
    [
        (changed("shafts", 1, start="150 mm"), "joins nodes at an axial distance of 10 mm"),
        (UNDAMPED, "no bearing has damping"),
        (changed("segments", 3, d_o="120 mm"), "changes by half"),
        (changed("segments", 4, length="5 mm", d_o="65 mm"), "beam theory does not apply"),
        (changed(speed="100 r/min"), "is not within the operating"),
        # the tube's bore is 50 mm; segment 7 of the core lies in its first two segments
        (changed("segments", 7, d_o="50 mm"), ""),
        (changed("segments", 7, d_o="52 mm"),
         "shafts overlap radially: segments[7], d_o = 52 mm, in the bore of segments[1], "
         "d_i = 50 mm, over 60 mm; segments[7], d_o = 52 mm, in the bore of segments[2], "
         "d_i = 50 mm, over 60 mm"),
        # half of 60 N/µm over 9000 r/min is 31.8 kN s/m
        (changed("supports", 1, c="31.7 kN s/m"), ""),
        (changed("supports", 1, c="32 kN s/m"), "supports[1]: damping times the highest operating"),
        (changed("supports", 1, cyy="32 kN s/m"), "supports[1]: damping times the highest"),
    ],
)  # fmt: skip
def test_an_odd_rotor_is_warned_of(raw, words):
    warned = texts_of(raw)[3]
    assert any(words in line for line in warned) if words else not warned
