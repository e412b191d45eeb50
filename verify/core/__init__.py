"""Units, inputs, cases, rows, figure data, files and texts: the base of all other packages."""
