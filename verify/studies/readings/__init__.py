"""Search for interpretations (readings) of inputs and results that give a printed number."""
