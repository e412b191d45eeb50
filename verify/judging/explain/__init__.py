"""Explanation of the judgement of rows, number by number."""
