"""Store the rows of this version in verify/audit/releases, for comparison with later versions."""

import sys
from pathlib import Path

from verify.app.release import release

ROOT = Path(__file__).parents[1]


def main() -> int:
    try:
        path = release(ROOT)
    except (ValueError, OSError) as error:
        print(f"release: {error}", file=sys.stderr)
        return 2
    print(f"{path.relative_to(ROOT)}: {path.stat().st_size / 1000:.0f} kB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
