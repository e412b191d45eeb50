"""Problems of the project as decks for calculix, run there, and its answers read back."""
