"""Contact of smooth elastic bodies: Hertz, partial slip, disc between flats, press fit."""
