"""Check whether every row has the same verdict on every machine: `freewheel portable`."""
