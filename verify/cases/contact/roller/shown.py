"""Warnings and figures of rollers modelled by slices; the reference is a half-space."""

from collections.abc import Iterator

from verify.cases.contact.roller import figures, half_space, texts
from verify.cases.contact.roller.formulas import SlicedRoller
from verify.core.case import Context
from verify.core.figures import Figure, Picture


class OnHalfSpace(SlicedRoller):
    """A roller modelled by strips and slices; the reference is a half-space."""

    refusal = half_space.too_short

    def warnings(self) -> Iterator[str]:
        """Warnings if the pressures are not valid for these inputs."""
        yield from texts.of_contact(self)
        yield from texts.of_materials(self)

    sketch = figures.sketch

    def pictures(self) -> Iterator[Picture]:
        """Picture of the pressure on the contact patch."""
        yield figures.patch()

    def along_roller(self, context: Context) -> Iterator[Figure]:
        """Figures: pressure and line load along the roller."""
        yield figures.pressures(context)
        yield figures.loads(context)
