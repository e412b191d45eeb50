from meshes.ring.quarter import quarter_ring
from meshes.ring.sector import half_sector

__all__ = ["half_sector", "quarter_ring"]
