"""Case files that `freewheel new-case` writes, one for each kind of problem."""
