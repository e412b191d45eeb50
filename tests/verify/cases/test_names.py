"""Names of rows in earlier versions lead to the present ones."""

import pytest

from verify.app.explain import find_row
from verify.audit.releases.store import load, path_of
from verify.cases.names import former_name, present_name

IDS = ["freewheel-torque/travel of the rollers (Eq. 6)", "freewheel-torque/normal force"]


@pytest.mark.parametrize(
    "old", ["way of the rollers", "freewheel-torque/way of the rollers (Eq. 6)"]
)
def test_a_row_is_found_by_its_old_name(old):
    assert find_row(old, IDS) == IDS[0]


def test_an_unknown_name_is_none_of_either():
    with pytest.raises(ValueError, match="no row matches"):
        find_row("way of the sprags", IDS)


def test_names_of_the_release_change_once():
    """What `present_name` returns is a present name: applied twice, it changes nothing more."""
    for old in load(path_of("0.1.0")).rows:
        new = present_name(old)
        assert present_name(new) == new
        assert present_name(former_name(new)) == new
