"""The comparison of two outputs: differences that it reports, and differences that it permits."""

import copy
import json

import pytest

from tools.same_rows import Comparison, main

ROW = {"id": "ring/bore", "status": "PASS", "kind": "identity", "reason": "differ by 2.2e-14, held",
       "fem": 1.5,
       "u_num": 1e-3, "levels": [[0.5, 1.4], [0.25, 1.5]]}  # fmt: skip
OUTPUT = {
    "rows": [ROW, copy.deepcopy(ROW) | {"id": "ring/rim", "fem": 2.5}],
    "provenance": {"made": "today"},
}


def changed(change):
    other = copy.deepcopy(OUTPUT)
    change(other)
    return other


def differences(change, *, exact=True):
    return [str(one) for one in Comparison(exact).differences(OUTPUT, changed(change))]


@pytest.mark.parametrize(
    ("change", "where"),
    [
        (lambda o: o["rows"][0].update(fem=1.5 * (1 + 2e-16)), "/rows[ring/bore]/fem"),
        (lambda o: o["rows"][0].update(status="FAIL"), "/rows[ring/bore]/status"),
        (lambda o: o["rows"][0].update(kind="fact"), "/rows[ring/bore]/kind"),
        (lambda o: o["rows"][1].update(reason="far"), "/rows[ring/rim]/reason"),
        (lambda o: o["rows"][1].update(fem="2.5"), "/rows[ring/rim]/fem"),
        (lambda o: o["rows"][1].update(fem=None), "/rows[ring/rim]/fem"),
        (lambda o: o["rows"].pop(), "/rows[ring/rim]: present -> missing"),
        (lambda o: o["rows"].append(ROW | {"id": "new"}), "/rows[new]: absent -> added"),
        (lambda o: o["rows"].reverse(), "/rows (order): ring/bore -> ring/rim"),
        (lambda o: o["rows"][0]["levels"].pop(), "/rows[ring/bore]/levels (length): 2 -> 1"),
        (lambda o: o["rows"][0]["levels"][1].__setitem__(1, 1.6), "levels[1][1]"),
        (lambda o: o["rows"][0].pop("kind"), "/rows[ring/bore][kind]: present -> missing"),
    ],
)
def test_every_change_is_reported_where_it_is(change, where):
    (found,) = differences(change)
    assert where in found


def with_reason(reason):
    return lambda o: o["rows"][0].update(reason=reason)


@pytest.mark.parametrize(
    ("change", "exactly", "on_another_machine"),
    [
        (lambda o: o.update(provenance={"made": "tomorrow"}), 0, 0),
        (lambda o: o["rows"][0].update(fem=1.5009), 1, 0),  # within the error of the row
        (lambda o: o["rows"][0].update(fem=1.5011), 1, 1),
        (lambda o: o["rows"][0].update(status="FAIL"), 1, 1),
        (lambda o: o["rows"][0].update(u_num=1.9e-3), 1, 0),  # within a factor of two
        (lambda o: o["rows"][0].update(u_num=2.1e-3), 1, 1),
        (with_reason("differ by 5.0e-14, held"), 1, 0),  # numbers of a text, and words
        (with_reason("differ by 5.0e-14, lost"), 1, 1),
    ],
)
def test_what_may_differ_from_run_to_run_and_on_another_machine(
    change, exactly, on_another_machine
):
    assert len(differences(change)) == exactly
    assert len(differences(change, exact=False)) == on_another_machine


def test_the_exit_status_and_the_count(tmp_path, capsys):
    one, other, names = (tmp_path / n for n in ("a.json", "b.json", "names.toml"))
    one.write_text(json.dumps(OUTPUT))
    other.write_text(json.dumps(changed(lambda o: o["rows"][1].update(id="ring/outside"))))
    assert main([str(one), str(one)]) == 0
    assert main([str(one), str(other)]) == 1
    assert "2 differences" in capsys.readouterr().out
    names.write_text('[[renamed]]\nwas = "ring/rim"\nnow = "ring/outside"\n')
    assert main([str(one), str(other), "--renamed", str(names)]) == 0
    assert main([str(one), str(tmp_path / "missing.json")]) == 2
