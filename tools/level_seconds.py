"""Writes verify/jobs/seconds.json from the store. Run `make verify` with an empty store first."""

import json

from verify.cases.registry import CASES
from verify.jobs.cache import default_folder
from verify.jobs.timing import USUAL, load

SHORTEST = 0.01  # s


def main() -> None:
    """Write the run time of every level of every case in seconds, to two digits."""
    known = load(default_folder())
    seconds = {
        case.id: {
            str(level): float(f"{max(known[case.id, level], SHORTEST):.2g}")
            for level in case.levels if (case.id, level) in known
        }
        for case in CASES
    }  # fmt: skip
    lines = ",\n".join(f'  "{case}": {json.dumps(levels)}' for case, levels in seconds.items())
    USUAL.write_text(f"{{\n{lines}\n}}\n", "utf-8")


if __name__ == "__main__":
    main()
