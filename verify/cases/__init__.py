"""Cases of the suite, with one package per subject."""
