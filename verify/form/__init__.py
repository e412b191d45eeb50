"""The form of a case: one class with inputs, formulas, a reference and comparisons."""
