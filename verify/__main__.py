"""`python -m verify` is `freewheel`."""

from verify.cli import main

main()
