"""A parameter file of a ring with stresses calculated by hand: 2.6 p and 1.6 p."""

RING = """\
case = "ring-lame"
[inputs]
r_i = "60 mm"
r_o = "90 mm"
p_i = "100 MPa"
E = "210 GPa"
nu = 0.3
"""
