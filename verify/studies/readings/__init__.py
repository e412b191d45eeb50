"""Search for the reading of inputs and number that reproduces what a paper prints."""
