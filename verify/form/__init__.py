"""The form of a case: one class that declares inputs, formulas, a reference, comparisons."""
