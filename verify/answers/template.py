"""The command `init`: a commented parameter file with the numbers of the paper."""

import json
import os
import sys
from io import TextIOWrapper
from pathlib import Path

from verify.answers.assumed.registry import ASSUMPTIONS
from verify.answers.template_lines import (
    CHOSEN,
    aligned,
    assigned,
    comment,
    commented,
    remark,
    sections,
)
from verify.cases.registry import CASES, DEEP, find
from verify.core.case import Case
from verify.core.inputs import REQUIRED, InputError, Inputs, entry_model, is_table, meta
from verify.papers.ledger import cited

HEAD = """\
# The numbers are {whose}. Replace them, then run
#   freewheel check my.toml          formulas, with warnings outside their range of validity
#   freewheel check --fem my.toml    also judged by finite elements for these parameters
# Every value has a unit; any other unit of the same dimension is accepted.

case = {case}
name = "my {id}"

[inputs]
"""
IN_A_LINE = """
# A table may also be written in one line, before the tables below:
#   segments = [{shaft = "a", length = "90 mm", d_o = "40 mm"}, {shaft = "a", length = ...}]
"""
TASKS = ("design-spring", "design-sprag")


def run_init(case_id: str, out: Path | None) -> int:
    """Print the template of a case, or write it to a new file."""
    try:
        case = find(case_id)
    except ValueError as error:
        raise InputError(f"{error}; tasks of freewheel design are {', '.join(TASKS)}") from error
    hand_over(template(case, Path() if out is None else out.parent), out)
    return 0


def hand_over(text: str, out: Path | None) -> None:
    """Print a template, or write it to a new file. Raises InputError if the file exists."""
    if out is None:
        if isinstance(sys.stdout, TextIOWrapper):
            sys.stdout.reconfigure(encoding="utf-8")  # TOML is UTF-8 on any terminal
        print(text, end="")
        return
    try:
        with out.open("x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError as error:
        raise InputError(f"{out}: exists already and is not overwritten") from error
    except OSError as error:
        raise InputError(f"{out}: cannot be written: {error.strerror}") from error


def template(case: Case, folder: Path = Path()) -> str:
    """Text of a parameter file with the paper's numbers; `folder` is the folder of the file.

    For a case with assumptions, the required inputs come first. The optional inputs with the
    numbers of the paper follow, and then examples of further inputs, each after a #. For a case
    without assumptions, the inputs follow in the order of the model.
    """
    printed = any(meta(field)["claims"] for field in case.inputs.model_fields.values())
    outside = case.id not in (*CASES.ids, *DEEP.ids)
    whose = f"the defaults of {case.named}" if outside \
        else f"the paper's ({cited(case.paper)}) where it prints them" if printed \
        else "this project's"  # fmt: skip
    name = os.path.relpath(case.file, folder.resolve()) if case.file else case.id
    what = remark(f"Parameters of the freewheel case {case.named}: {case.title}.")
    head = what + HEAD.format(id=case.id, whose=whose, case=json.dumps(name, ensure_ascii=False))
    assumptions = ASSUMPTIONS.get(case.id, ())
    if assumptions:
        body = sections(case.inputs, assumptions, "the paper's" if printed else "this project's")
        body += IN_A_LINE if any(map(is_table, case.inputs.model_fields.values())) else ""
    else:
        body = aligned(commented(case.inputs, "" if outside else CHOSEN))
    return head + body + _instead(case.inputs) + _tables(case.inputs)


def _instead(model: type[Inputs]) -> str:
    """Lines after a # with the alternative set of inputs; empty if the model has none."""
    what, values = model.instead
    if not what:
        return ""
    return f"\n# Or {what}\n" + "".join(f"#   {name} = {text}\n" for name, text in values.items())


def _tables(model: type[Inputs]) -> str:
    """All tables of the model.

    The first entry of each table has full comments, the others have none.
    """
    found = ""
    for name, field in model.model_fields.items():
        if not is_table(field):
            continue
        own, about = entry_model(field), meta(field)
        optional = "" if about["omitted"] == REQUIRED else " Optional."
        found += "\n" + remark(about["what"] + optional)
        entries = field.default or (own(),)
        hidden = "" if field.default else "# "
        for k, entry in enumerate(entries):
            lines = [(assigned(n, f, getattr(entry, n)), comment(n, f, ""))
                     for n, f in own.model_fields.items()]  # fmt: skip
            if k == 0:
                body = aligned(lines) + _instead(own)
            else:
                body = "".join(f"{line}\n" for line, _ in lines if not line.startswith("#"))
            text = f"[[inputs.{name}]]\n{body}"
            found += "".join(f"{hidden}{line}\n" for line in text.splitlines())
            found += "\n" if k + 1 < len(entries) else ""
    return found
