"""Pictures of contact patches are magnified across the roller as their captions state."""

import pytest

from verify.cases.contact.roller import end_figures, figures


@pytest.mark.parametrize("picture", [figures.patch(), end_figures.patch()])
def test_the_caption_states_the_magnification_of_the_picture(picture):
    assert picture.stretch > 1
    assert f"magnified {picture.stretch:.0f} times" in picture.caption
