from meshes.shell.panel import cylinder_panel, rectangle
from meshes.shell.strip import swept_path
from meshes.shell.surface import ShellMesh

__all__ = ["ShellMesh", "cylinder_panel", "rectangle", "swept_path"]
