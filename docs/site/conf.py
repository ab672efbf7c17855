"""How Sphinx makes the site of the documents: scripts/build-docs, which is `make docs`.

What it reads is not this tree but build/docs/pages, which stage.py makes of it.
"""

import sys
from pathlib import Path
from typing import Any

here = Path(__file__).resolve().parent
root = here.parents[1]
sys.path[:0] = [str(here), str(root / "python")]

import beespace  # noqa: E402
import notebooks  # noqa: E402
import python_pages  # noqa: E402

project = "beespace"
release = beespace.__version__
html_title = f"beespace {release}"

extensions = [
    "myst_nb",
    "breathe",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "sphinx_design",
]
exclude_patterns = ["**.ipynb_checkpoints"]

# The documents, whose links are also followed by GitHub and by tests/packaging/links_test.sh.
myst_heading_anchors = 6
myst_enable_extensions = ["colon_fence"]
# Notebooks are run while the site is built; one that fails is an error.
nb_execution_mode = "force"
nb_execution_excludepatterns = list(notebooks.NOT_RUN)
nb_execution_timeout = 120
nb_execution_raise_on_error = True

# The package for Python. Its docstrings say the types in words.
autodoc_typehints = "none"
autodoc_member_order = "bysource"
# `name` in a docstring leads to what has that name, where it is public.
default_role = "py:obj"
napoleon_google_docstring = False
napoleon_use_ivar = True
napoleon_use_rtype = False

# The headers for C and C++, as doxygen read them.
breathe_projects = {"beespace": str(root / "build/docs/headers/xml")}
breathe_default_project = "beespace"
breathe_show_include = False
breathe_default_members = ("members",)
# Each header has a page, and each page opens the namespace; doxygen tells of each structure for C as
# a structure and as a type. What is said twice is found by doxygen, whose warnings are errors.
suppress_warnings = ["duplicate_declaration.cpp"]

html_theme = "furo"
html_static_path = [str(here / "static")]
html_css_files = ["site.css"]
html_copy_source = False
# Its search works from files, too, where a page cannot read another one.
html_show_search_summary = False
html_show_sphinx = False
html_show_copyright = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#8a5a00", "color-brand-content": "#8a5a00"},
    "dark_css_variables": {"color-brand-primary": "#f2b134", "color-brand-content": "#f2b134"},
}
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True
copybutton_exclude = ".linenos, .gp, .go"


def without_namespace(_app: Any, tree: Any) -> None:
    """Each page of a header says first what the header is for, not again what beespace is."""
    from docutils import nodes
    from sphinx import addnodes

    for described in list(tree.findall(addnodes.desc)):
        if described.get("objtype") != "type" or not described.astext().startswith("namespace"):
            continue
        place = nodes.target(ids=[each for line in described.children[:-1] for each in line["ids"]])
        content = [each for each in described.children[-1] if each.tagname != "paragraph"]
        entry = described.parent[described.parent.index(described) - 1]
        if isinstance(entry, addnodes.index):
            described.parent.remove(entry)
        described.parent.replace(described, [place, *content])


def with_public_links(_app: Any, tree: Any) -> None:
    """Names and words for types in docstrings ("array of shape (n, 3)") lead to what is public."""
    from docutils import nodes
    from sphinx import addnodes

    public = {name.removeprefix("beespace.") for name in python_pages.public()}
    for reference in list(tree.findall(addnodes.pending_xref)):
        if reference.get("refdomain") != "py":
            continue
        target = reference["reftarget"].removeprefix("beespace.")
        if target not in public:
            reference.replace_self(reference.children)
    for name in tree.findall(nodes.field_name):
        if name.astext() == "Variables":
            name.children = [nodes.Text("Attributes")]


def setup(app: Any) -> None:
    app.connect("doctree-read", without_namespace)
    app.connect("doctree-read", with_public_links)
