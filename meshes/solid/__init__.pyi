from meshes.solid.block import solid_block
from meshes.solid.strip import solid_strip

__all__ = ["solid_block", "solid_strip"]
