"""Range of use of each formula: regions about the papers' inputs, measured and stored."""
