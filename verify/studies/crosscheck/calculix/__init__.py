"""Problems of the project as input files (decks) for calculix; runs of calculix; results."""
