"""What earlier releases found, row by row, and what has moved since."""
