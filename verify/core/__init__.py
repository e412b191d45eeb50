"""Base of all other packages: units, inputs, cases, rows, figure data, files and texts."""
