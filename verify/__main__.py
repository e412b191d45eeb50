"""Entry point of `python -m verify`, which is the command `freewheel`."""

from verify.app.cli import main

main()
