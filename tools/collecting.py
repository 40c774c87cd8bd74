"""Collects what the window and the report say: their own words, the core's tables of words, and templates of the core's
sentences."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MARKS = {"tr", "noted", "inline"}
_SHARED = ("gearstudio/words.py", "gearstudio/cli/report_pictures.py", "ui/vocabulary.py", "ui/reporting/pictures.py")
"""Words that belong to sentences of the core, and reasons why a picture is missing in the report."""
_QUIET_WINDOW = {
    "diagnostics",
    "zebra",
    "theme",
    "settings_file",
    "number_slider",
    "command",
    "memory",
    "still",
    "words",
    "sentences",
}
"""Modules of the window whose tables are not for people, or for the command line."""
_QUIET_CORE = ("cli", "equations", "presets", "catalogue", "formats", "design/model", "design/pair",
               "design/lengthwise", "design/tooth", "design/blank", "design/modifications", "design/choices",
               "exchange/stl", "exchange/threemf", "exchange/points", "analysis/datasheet", "analysis/selfcheck",
               "analysis/measurement_errors", "wire", "worker")  # fmt: skip
"""Modules of the core whose texts are tables (collected as such), files or output of the command line."""
_TITLE = re.compile(r"^[✓✗]? ?&?[A-Z][a-z&]|[A-Za-z]{2,} [A-Za-z(“]")
_NO_TITLE = re.compile(r"^(Ctrl|Shift|Alt)\+|;;.*\*|^[\w.]*_[\w.]*$|Keys\.|::|^#|^[A-Z][a-z]+[A-Z]\w+$|^\w+ \{")
_SENTENCE = re.compile(r"[a-z]{2,}[,;:]? +\{?[a-z(]|^[a-z]+ \{0\}")
_NO_SENTENCE = re.compile(r"^\S+ = |[\\<>\n]|^%|\d+ of theory \[|=\s*\{0\}$|^[^a-z]*$")
_NAME = re.compile(r"\{[a-z_]+\}")
_FUNCTION = re.compile(r"arc(cos|sin|tan)|half|z_mate|γ_mate|_tip")
_IN_WORDS = re.compile(r"(?<!\w)(?:at|or|[a-z]{4,})(?!\w)")
"""A formula that is said in words, at least in part."""
_MORE_SENTENCES = {
    "{0}: {1} failed: {2}", "{0} to {1}", "{0} teeth", "building", "checking", "weighing", "reading", "convergence",
    "it was killed by {0}", "it ended with exit status {0}", "it stopped answering",
}  # fmt: skip
"""Of errors that are put together with few words, stages of work that are one, and how the CAD process ended."""


def window_words() -> set[str]:
    """English texts of the window: literals given to `tr` and its like, and the titles in tables of modules."""
    found: set[str] = set()
    for path in sorted((ROOT / "ui").rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        found |= set(_marked(tree))
        if path.stem not in _QUIET_WINDOW:
            found |= {text for text in _in_tables(tree) if _TITLE.search(text) and not _NO_TITLE.search(text)}
    return found


def report_words() -> set[str]:
    """English texts of the report: literals given to `tr` and its like, and the core's single words."""
    files = (*sorted((ROOT / "gearstudio" / "report").rglob("*.py")), *(ROOT / name for name in _SHARED))
    return {text for path in files for text in _marked(ast.parse(path.read_text(encoding="utf-8")))}


def table_words() -> set[str]:
    """Titles, descriptions and other words that stand in the core's tables."""
    from gearstudio.analysis.selfcheck import self_check
    from gearstudio.catalogue import METHOD_INFOS
    from gearstudio.design import all_field_specs
    from gearstudio.formats import OPTIONS
    from gearstudio.presets import PRESETS
    from gearstudio.report.sections import SECTIONS

    found = {spec.description for spec in all_field_specs().values()} | {one.summary for one in SECTIONS}
    for preset in PRESETS:
        found |= {preset.title, preset.description}
    for info in METHOD_INFOS:
        found |= {info.summary, info.paper_section}
    for option in OPTIONS.values():
        found |= {option.title, option.help, *(title for _, title in option.choices)}
    for check in self_check():
        found |= {check.source, *check.name.split(": ")}
    return report_tables() | _worded(found)


def report_tables() -> set[str]:
    """Those words of the core's tables that the report shows too."""
    from gearstudio.analysis.convergence import COUNTED
    from gearstudio.analysis.datasheet import data_sheet
    from gearstudio.analysis.measurement_errors import NAMED_ERRORS
    from gearstudio.catalogue import METHOD_INFOS
    from gearstudio.design import Design, all_field_specs
    from gearstudio.design.choices import choice_title
    from gearstudio.equations import EQUATIONS
    from gearstudio.presets import PRESETS
    from gearstudio.report.sections import SECTIONS

    found: set[str] = {*COUNTED.values(), *(info.title for info in METHOD_INFOS), *(one.title for one in SECTIONS)}
    found |= {error.title for error in NAMED_ERRORS}
    for spec in all_field_specs().values():
        found |= {spec.title, spec.group, *map(choice_title, spec.choices)}
    for equation in EQUATIONS:
        found |= {equation.title, equation.meaning, equation.departure, equation.evidence, equation.group}
        found.add(equation.section)
    for design in (Design(), *(preset.design for preset in PRESETS)):
        for quantity in data_sheet(design).quantities:
            found |= {quantity.name, quantity.group}
            if _IN_WORDS.search(_FUNCTION.sub("", quantity.formula)):
                found.add(quantity.formula)
    return _worded(found)


def _worded(texts: set[str]) -> set[str]:
    return {text for text in texts if re.search("[A-Za-z]{2}", text)}


def core_sentences() -> set[str]:
    """Templates of the core's messages: text with numbered holes, ``"{0} is not a finite number; {1}"``.

    Of the window and of the report those of errors and of stages of work alone; all else they mark themselves.
    """
    found: set[str] = set()
    for folder in ("gearstudio", "ui"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            name = path.relative_to(ROOT / folder).as_posix()
            if folder == "ui" or not name.startswith(_QUIET_CORE):
                tree, marked = ast.parse(path.read_text(encoding="utf-8")), folder == "ui" or name.startswith("report/")
                found |= set(_templates(tree, errors_only=marked))
    return _MORE_SENTENCES | {text for text in found if _SENTENCE.search(text) and not _NO_SENTENCE.search(text)}


def _marked(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in MARKS and node.args:
            for part in ast.walk(node.args[0]):
                if isinstance(part, ast.Constant) and isinstance(part.value, str) and not _is_key(part, node.args[0]):
                    yield part.value


def _is_key(constant: ast.Constant, within: ast.AST) -> bool:
    """Whether a constant only selects among texts or serves a call, and is none itself."""
    for node in ast.walk(within):
        if isinstance(node, ast.Subscript) and constant in ast.walk(node.slice):
            return True
        if isinstance(node, ast.Call | ast.Compare | ast.JoinedStr) and constant in ast.walk(node):
            return True
    return False


def _in_tables(tree: ast.Module) -> Iterator[str]:
    for statement in tree.body:
        if isinstance(statement, ast.Assign | ast.AnnAssign) and statement.value is not None:
            if any(isinstance(t, ast.Name) and t.id == "__all__" for t in getattr(statement, "targets", ())):
                continue
            yield from _values(statement.value)


def _values(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Constant):
        if isinstance(node.value, str):
            yield node.value
    elif isinstance(node, ast.Dict):
        for value in node.values:
            yield from _values(value)
    elif not isinstance(node, ast.JoinedStr | ast.Lambda | ast.Subscript):
        for child in ast.iter_child_nodes(node):
            yield from _values(child)


def _templates(tree: ast.Module, *, errors_only: bool) -> Iterator[str]:
    quiet = set(_documentation(tree))

    def visit(node: ast.AST, wanted: bool) -> Iterator[str]:
        if node in quiet:
            return
        if isinstance(node, ast.Call):
            name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            if name in ("tr", "noted", "inline", "getLogger", "warning", "info", "exception", "debug", "critical"):
                return
            wanted = wanted or name.endswith(("Error", "Failed", "Issue", "_failed", "_tell")) or name == "report"
            if name in ("ValueError", "TypeError", "RuntimeError", "AssertionError", "KeyError"):
                return
        text = template(node) if wanted or not errors_only else None
        if text is not None:
            yield text
        inner = _holes(node) if text is not None else ast.iter_child_nodes(node)
        for child in inner:
            yield from visit(child, wanted)

    yield from visit(tree, False)


def template(node: ast.AST) -> str | None:
    """A text of the source with numbered holes for what is put in; None for what is no text."""
    parts = _parts(node)
    if parts is None:
        return None
    number, text = 0, ""
    for part in parts:
        if part is None:
            text, number = f"{text}{{{number}}}", number + 1
        else:
            text += part
    return text


def _parts(node: ast.AST) -> list[str | None] | None:
    if isinstance(node, ast.Constant):
        return _named(node.value) if isinstance(node.value, str) else None
    if isinstance(node, ast.JoinedStr):
        return [str(v.value) if isinstance(v, ast.Constant) else None for v in node.values]
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        left, right = _parts(node.left), _parts(node.right)
        if left is not None and right is not None:
            return left + right
    return None


def _named(text: str) -> list[str | None]:
    """A text with holes such as ``{name}``, which are filled in later."""
    parts: list[str | None] = []
    for number, part in enumerate(_NAME.split(text)):
        parts += [None, part] if number else [part]
    return parts


def _holes(node: ast.AST) -> Iterator[ast.AST]:
    if isinstance(node, ast.JoinedStr):
        yield from (value.value for value in node.values if isinstance(value, ast.FormattedValue))
    elif isinstance(node, ast.BinOp):
        yield from _holes(node.left)
        yield from _holes(node.right)


def _documentation(tree: ast.Module) -> Iterator[ast.AST]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            yield node.value
