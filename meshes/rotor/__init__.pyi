from meshes.rotor.stepped import stepped_section

__all__ = ["stepped_section"]
