"""`python -m verify` is `freewheel`."""

from verify.app.cli import main

main()
