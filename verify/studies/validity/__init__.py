"""Range of use of each formula: regions around the inputs of the papers, measured and stored."""
