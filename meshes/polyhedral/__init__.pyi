from meshes.polyhedral.half_sector import half_sector as polygon_half_sector

__all__ = ["polygon_half_sector"]
