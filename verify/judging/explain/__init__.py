"""How rows were judged, number by number."""
