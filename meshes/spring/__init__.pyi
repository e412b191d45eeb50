from meshes.spring.centre_line import centre_line as spring_centre_line
from meshes.spring.strip import strip as spring_strip

__all__ = ["spring_centre_line", "spring_strip"]
