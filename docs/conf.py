"""Settings of the documentation, which `make docs` builds."""

import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "docs" / "_extensions")]
with (ROOT / "pyproject.toml").open("rb") as _file:
    _project = tomllib.load(_file)["project"]

project = "Freewheel verification"
release = _project["version"]
extensions = [
    "myst_parser", "sphinx.ext.autodoc", "sphinx.ext.autosummary", "sphinx.ext.napoleon",
    "docstrings", "equations", "gallery", "theory",
    "console", "figures", "navigation", "outside",
]  # fmt: skip
nitpicky = True  # a reference without a target is a warning
nitpick_ignore_regex = [("py:(class|exc|data)", ".*"), ("py:obj", "None|True|False")]  # types
templates_path = ["_templates"]
exclude_patterns = ["_build", "theory/_generated"]
default_role = "code"
suppress_warnings = ["ref.footnote"]  # docstrings list sources without footnote numbers in the text

myst_enable_extensions = ["dollarmath", "deflist", "colon_fence"]
myst_heading_anchors = 3

autodoc_default_options = {"members": True}
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # types are those of the source (_extensions/docstrings.py)
napoleon_google_docstring = False
maximum_signature_line_length = 80
python_use_unqualified_type_names = True

html_theme = "furo"
html_title = f"Freewheel verification {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_math_renderer = "typeset"
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_show_sourcelink = False
