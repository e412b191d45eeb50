"""Clutch and rotor: stiffness in closed form, rotating shafts, exact transfer matrices."""
