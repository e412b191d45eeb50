"""Names of rows in earlier versions lead to the present ones."""

import pytest

from verify.app.explain import find_row
from verify.audit.releases.store import load, path_of
from verify.cases.names import former_name, present_name


def test_a_row_is_found_by_its_old_name_and_an_unknown_one_is_refused():
    ids = ["freewheel-torque/travel of the rollers (Eq. 6)", "freewheel-torque/normal force"]
    for old in ("way of the rollers", "freewheel-torque/way of the rollers (Eq. 6)"):
        assert find_row(old, ids) == ids[0]
    with pytest.raises(ValueError, match="no row matches"):
        find_row("way of the sprags", ids)


@pytest.mark.parametrize("version", ["0.1.0", "0.2.0"])
def test_names_of_a_release_change_once(version):
    for old in load(path_of(version)).rows:
        new = present_name(old)
        assert present_name(new) == present_name(former_name(new)) == new


@pytest.mark.parametrize("version", ["0.1.0", "0.2.0"])
def test_explain_finds_each_row_by_its_complete_earlier_name(version):
    ids = [*dict.fromkeys(present_name(old) for old in load(path_of("0.2.0")).rows)]
    for old in load(path_of(version)).rows:
        assert find_row(old, ids) == present_name(old)


def test_names_of_the_first_release_lead_to_rows_of_the_second():
    first, second = (load(path_of(version)).rows for version in ("0.1.0", "0.2.0"))
    assert {present_name(old) for old in first} <= {present_name(old) for old in second}
