"""Design of accordion springs by the rules of Wang et al. 2023, extended (Eqs. 11-13, Fig. 12)."""
