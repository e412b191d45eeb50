"""Bodies of revolution under loads that vary round the axis: one problem in (r, z) per harmonic."""
