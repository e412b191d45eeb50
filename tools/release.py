"""Release the committed code as a version: `tools/release.py 0.2.0`; see CONTRIBUTING.md."""

import sys
from pathlib import Path

from verify.app.release import release

ROOT = Path(__file__).parents[1]


def main(arguments: list[str]) -> int:
    if len(arguments) != 1:
        print("release: needs one argument, the version, such as 1.0.2", file=sys.stderr)
        return 2
    try:
        path = release(ROOT, arguments[0])
    except (ValueError, OSError) as error:
        print(f"release: {error}", file=sys.stderr)
        return 2
    print(f"{path.relative_to(ROOT)}: {path.stat().st_size / 1000:.0f} kB")
    print(f"committed, with the tag v{arguments[0]}: git push --follow-tags publishes it")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
