from meshes.contact.block import block as even_block
from meshes.contact.block import full_block, half_block
from meshes.contact.disc import half_disc, quarter_disc
from meshes.contact.race import half_race
from meshes.contact.roller import half_roller
from meshes.contact.round import full_disc, full_ring
from meshes.contact.tilted import tilted_half_disc

__all__ = [
    "even_block", "full_block", "full_disc", "full_ring", "half_block", "half_disc",
    "half_race", "half_roller", "quarter_disc", "tilted_half_disc",
]  # fmt: skip
