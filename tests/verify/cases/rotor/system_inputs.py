"""Raw inputs of a rotor, those of the template with some changed."""

import json

from tests.verify.template_text import inputs_of
from verify.answers.template import template
from verify.cases.rotor.system.case import SYSTEM, RotorSystem
from verify.core.inputs import build

RAW = inputs_of(template(SYSTEM))


def changed(table=None, entry=1, drop=(), **values):
    """The template's inputs with an entry's values changed, or those of the top."""
    raw = json.loads(json.dumps(RAW))
    at = raw if table is None else raw[table][entry - 1]
    at.update(values)
    for key in drop:
        del at[key]
    return raw


def built(raw):
    return build(RotorSystem, raw, "r.toml")
