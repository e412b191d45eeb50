from fem.fourier.contact import NarrowPatchError, PatchContact, patch_contact
from fem.fourier.solid import FourierSolid, Harmonic
from fem.fourier.solution import FourierSolution, HarmonicSolution
from fem.fourier.vibration import RotatingSolid, WhirlModes
from fem.fourier.vibration_mounts import Mount, RigidDisc

__all__ = [
    "FourierSolid", "FourierSolution", "Harmonic", "HarmonicSolution", "Mount",
    "NarrowPatchError", "PatchContact", "RigidDisc", "RotatingSolid", "WhirlModes",
    "patch_contact",
]  # fmt: skip
