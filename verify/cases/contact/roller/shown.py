"""Figures of rollers in slices, with the half-space."""

from collections.abc import Iterator

from verify.cases.contact.roller import figures, half_space, texts
from verify.cases.contact.roller.formulas import SlicedRoller
from verify.core.case import Context
from verify.core.figures import Figure, Picture


class OnHalfSpace(SlicedRoller):
    """A roller in strips and slices whose reference is a half-space."""

    refusal = half_space.too_short

    def warnings(self) -> Iterator[str]:
        """Warnings on the validity of these pressures."""
        yield from texts.of_contact(self)
        yield from texts.of_materials(self)

    sketch = figures.sketch

    def pictures(self) -> Iterator[Picture]:
        """Pressure on the patch."""
        yield figures.patch()

    def along_roller(self, context: Context) -> Iterator[Figure]:
        """Pressure and line load along the roller."""
        yield figures.pressures(context)
        yield figures.loads(context)
