"""Design of accordion springs by Wang et al. 2023 (Eqs. 11-13, Fig. 12) and additional limits."""
