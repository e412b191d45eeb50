"""Base of all other packages of `verify`: units, inputs, cases, rows, figure data, files, texts."""
