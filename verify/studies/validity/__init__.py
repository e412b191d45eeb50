"""Where each formula may be used: regions about the papers' inputs, measured and stored."""
