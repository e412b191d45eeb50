"""Results of earlier releases, row by row, and the changes since then."""
