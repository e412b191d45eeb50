from meshes.revolution.cylinder import half_cylinder
from meshes.revolution.section import section as half_section

__all__ = ["half_cylinder", "half_section"]
