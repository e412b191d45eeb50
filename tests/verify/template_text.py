"""Templates with their optional lines included."""

import re
import tomllib

EXAMPLES = "# Also optional"
CONTINUED = re.compile(r"\n(?:# )?#? +#   ")  # a long comment
HIDDEN = re.compile(r"^# (\w+ = )")


def whole(text):
    """A template with all lines of the paper's numbers, without the examples and inside tables."""
    lines, left = [], False
    for line in text.splitlines(keepends=True):
        left = line.startswith((EXAMPLES, "[[inputs.")) or (left and line.strip() != "")
        lines.append(line if left else HIDDEN.sub(r"\1", line))
    return "".join(lines)


def inputs_of(text):
    """The raw inputs of a template with all lines of the paper's numbers."""
    return tomllib.loads(whole(text))["inputs"]


def joined(text):
    """A template with each comment in one line."""
    return CONTINUED.sub(" ", text)
