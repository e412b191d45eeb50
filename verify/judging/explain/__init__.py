"""Step-by-step explanation of how rows were judged."""
