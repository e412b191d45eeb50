"""Expected errors of a roller freewheel's formulas."""
