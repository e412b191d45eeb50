"""A quantity in colours over a plane: the right colour at the right place, named and bounded."""

import base64
import io
import re

import numpy as np
from PIL import Image

from reports.density import density
from reports.ramps import UNSIGNED
from verify.core.figures import Density

X, Y = np.linspace(0.0, 60.0, 61), np.linspace(-4.5, 4.5, 41)


def drawn(z, **more):
    given = {"title": "t", "x_label": "t [ms]", "y_label": "y [mm]", "z_label": "p [MPa]"}
    return str(density(Density(**given, x=X, y=Y, z=z, **more)))


def pixels(page):
    data = re.search(r'base64,([^"]*)"', page)[1]
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(data))).convert("RGBA")).astype(int)


def near(colour, name):
    return np.abs(colour[:3] - np.array(list(bytes.fromhex(name[1:])))).max() < 12


def test_the_first_row_is_at_the_bottom_and_the_first_column_at_the_left():
    z = np.zeros((41, 61))
    z[:10, :10] = 1.0
    seen = pixels(drawn(z))
    assert near(seen[-3, 3], UNSIGNED[-1])
    assert near(seen[3, 3], UNSIGNED[0])
    assert near(seen[-3, -3], UNSIGNED[0])


def test_where_there_is_no_value_nothing_is_drawn():
    z = np.ones((41, 61))
    z[20:, :] = np.nan
    seen = pixels(drawn(z, range=(0.0, 2.0)))
    assert seen[10, 100, 3] == 0
    assert seen[-10, 100, 3] == 255
