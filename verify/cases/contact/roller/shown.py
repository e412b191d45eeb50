"""What reports show of rollers in slices, beside the half-space."""

from collections.abc import Iterator

from verify.cases.contact.roller import figures, half_space, texts
from verify.cases.contact.roller.formulas import SlicedRoller
from verify.core.case import Context
from verify.core.figures import Figure, Picture, Sketch


class OnHalfSpace(SlicedRoller):
    """A roller in strips and slices whose reference is a half-space."""

    def refusal(self) -> str:
        """Where the half-space cannot resolve the ends."""
        return half_space.too_short(self)

    def warnings(self) -> Iterator[str]:
        """What an engineer should know before trusting these pressures."""
        yield from texts.of_contact(self)
        yield from texts.of_materials(self)

    def sketch(self) -> Sketch:
        """Roller and race from the side."""
        return figures.sketch(self)

    def pictures(self) -> Iterator[Picture]:
        """Pressure on the patch."""
        yield figures.patch()

    def along_roller(self, context: Context) -> Iterator[Figure]:
        """Pressure and line load along the roller."""
        yield figures.pressures(context)
        yield figures.loads(context)
