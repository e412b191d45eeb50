from meshes.sprag.profile import Sprag
from meshes.sprag.sector import sprag_sector

__all__ = ["Sprag", "sprag_sector"]
