"""Problems of the project as decks for calculix; runs of calculix, and their results."""
