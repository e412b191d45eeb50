from analytic.contact import (
    disc_stress,
    hertz_line,
    hertz_line_approach,
    hertz_line_stress,
    hertz_point,
    lamina,
    palmgren,
    partial_slip,
    slices,
    strips,
    tangential_cycle,
)
from analytic.contact.best_crown import BestCrown
from analytic.contact.best_crown import best_crown as optimal_crown
from analytic.contact.crown import johns_gohar, logarithmic, lundberg, slice_centres
from analytic.contact.disc import PressedDisc, disc_in_contact, disc_under_load
from analytic.contact.half_space_roller import RollerContact, press_roller
from analytic.contact.partial_slip import dundurs_beta
from analytic.contact.press_fit import Wall, contact_pressures, interferences_lost
from analytic.contact.sphere_series import PressedSpheres, Sphere, pressed_spheres
from analytic.contact.two_bodies import contact_modulus, relative_radius

__all__ = [
    "BestCrown", "PressedDisc", "PressedSpheres", "RollerContact", "Sphere", "Wall",
    "contact_modulus", "contact_pressures", "disc_in_contact", "disc_stress", "disc_under_load",
    "dundurs_beta", "hertz_line", "hertz_line_approach", "hertz_line_stress", "hertz_point",
    "interferences_lost", "johns_gohar", "lamina", "logarithmic", "lundberg", "optimal_crown",
    "palmgren", "partial_slip", "press_roller", "pressed_spheres", "relative_radius",
    "slice_centres", "slices", "strips", "tangential_cycle",
]  # fmt: skip
