"""Long measurements: valid while their code is unchanged, resumed after an interruption."""

from dataclasses import replace

import numpy as np
import pytest

from verify.cases import registry
from verify.cases.spring.accordion.case import ACCORDION
from verify.core.case import FemResult
from verify.core.inputs import InputError
from verify.jobs import cache, deep_results, records
from verify.jobs.scheduler import run
from verify.studies import deep, deep_cases

PARTS = (
    FemResult(h=1.0, values={"k": 1.5}, arrays={"map": np.arange(6.0).reshape(2, 3)}),
    FemResult(h=0.5, values={"k": 1.25}, u_it={"k": 1e-9}),
)
FAST = replace(ACCORDION, id="spring-deep", levels=(2, 4), checks=())


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setattr(records, "FOLDER", tmp_path / "measured")
    monkeypatch.setattr(registry, "DEEP", (FAST,))
    monkeypatch.setattr(registry, "CASES", ())
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))

    def in_this_process(work, _jobs, _use_cache):
        """A spawned process would not have the case of the tests."""
        return run(work, cache_folder=cache.default_folder())

    monkeypatch.setattr(deep_cases, "solve", in_this_process)
    return tmp_path / "measured" / "deep"


def test_a_record_is_read_again_while_code_inputs_and_file_stand(folder):
    path = deep_results.keep(FAST, PARTS)
    found = deep_results.measured(FAST)
    assert found.parts[0].arrays["map"].tolist() == PARTS[0].arrays["map"].tolist()
    assert (found.parts[1].values, found.parts[1].u_it) == ({"k": 1.25}, {"k": 1e-9})
    other_inputs = replace(FAST, inputs=lambda: ACCORDION.inputs(n=8))
    other_code = replace(FAST, reference=lambda _q, _level: None)
    assert deep_results.measured(other_inputs) is deep_results.measured(other_code) is None
    path.write_text(path.read_text("utf-8").replace('"values"', '"value"', 1), "utf-8")
    assert deep_results.measured(FAST) is None


def test_a_measurement_is_made_once_and_not_where_a_part_fails(folder, monkeypatch, capsys):
    def broken(_inputs, _level):
        raise ArithmeticError("no root")

    monkeypatch.setattr(registry, "DEEP", (replace(FAST, id="broken", reference=broken), FAST))
    assert deep.run_deep([], jobs=1) == 1
    printed = capsys.readouterr().out
    assert "no root" in printed
    assert "spring-deep: 2 parts measured" in printed
    assert [path.name for path in folder.iterdir()] == ["spring-deep.json"]
    monkeypatch.setattr(registry, "DEEP", (FAST,))
    assert deep.run_deep([], jobs=1) == 0
    assert "measured already" in capsys.readouterr().out


def test_an_unknown_measurement_is_named_with_the_known(folder):
    with pytest.raises(ValueError, match=r"'spring-dep', did you mean spring-deep\? there are "):
        deep.run_deep(["spring-dep"], jobs=1)
    for name in ("validity:other", "validity:"):
        with pytest.raises(InputError, match=f"{name.rstrip(':')}: unknown study"):
            deep.run_deep(["spring-deep", name], jobs=1)
    assert not folder.exists()  # found before anything is measured


def test_names_choose_studies_and_their_cases(folder, monkeypatch):
    """Of two cases that of a ring is measured; a budget is what fails."""
    asked = {}
    ring = replace(FAST, id="ring-deep")

    def study(kind):
        def measure(missing, _where, again):
            asked[kind.name] = [case.id for case in missing] + ["again"] * again
            return kind.name != "budget"

        return replace(
            kind, cases=lambda: (FAST, ring), is_measured=lambda c: c is ring, measure=measure
        )

    kinds = [study(kind) for kind in deep.STUDIES.values()]
    monkeypatch.setattr(deep, "DEEP_CASES", kinds[0])
    monkeypatch.setattr(deep, "STUDIES", {kind.name: kind for kind in kinds})
    assert deep.run_deep([], jobs=1) == 1
    assert asked == {name: ["spring-deep"] for name in ("", "validity", "budget")}
    asked.clear()
    assert deep.run_deep(["budget:spring-deep", "budget"], jobs=1, again=True) == 1
    assert asked == {"budget": ["spring-deep", "ring-deep", "again"]}
