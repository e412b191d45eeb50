"""Typesetting of templates by typst; its errors become messages of one line."""

from typing import Any

from reports.standalone import HERE


class NotSet(Exception):  # noqa: N818 - the name states the failure
    """Error if typst cannot process a template; the message states the reason in one line."""


def typeset(template: str, inputs: dict[str, str], **options: Any) -> Any:
    """Output of typst for a template with `inputs` and `options`. Raises NotSet if typst fails."""
    try:
        import typst  # its absence is no reason to write no report
    except ImportError as error:
        raise NotSet(f"typst cannot be imported: {error}") from error
    try:
        return typst.compile(HERE / template, root=HERE, sys_inputs=inputs, **options)
    except RuntimeError as error:
        raise NotSet(" ".join(str(error).split())) from error
    except BaseException as error:
        if type(error).__name__ != "PanicException":  # how a fault inside typst arrives
            raise
        raise NotSet(f"typst failed: {' '.join(str(error).split())}") from error
