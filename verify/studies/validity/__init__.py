"""Where each formula may be used: regions about the papers' inputs, measured once and kept."""
