"""Design of accordion springs by Eqs. 11-13 of Wang et al. 2023 (Fig. 12) and other limits."""
