"""Units, inputs, cases, rows, figure data, files and texts: what all other packages build on."""
