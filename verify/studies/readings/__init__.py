"""Search for the reading of inputs and result that gives a printed number."""
