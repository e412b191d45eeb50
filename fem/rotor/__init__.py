"""Rotors of coaxial shafts as beams: vibration, critical speeds and unbalance response."""
