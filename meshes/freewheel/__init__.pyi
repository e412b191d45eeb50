from meshes.freewheel.sector import inner_cam_sector, outer_cam_sector

__all__ = ["inner_cam_sector", "outer_cam_sector"]
