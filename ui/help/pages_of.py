"""The pages of the help: where they are, in which language, and what a link to a heading is called."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from ui.words import noted, tr

HERE = Path(__file__).parent
PAGES = (("guide", "Guide"), ("glossary", "Glossary"))
LANGUAGE = noted("en")
"""Its translation is the code of the language that the window speaks, and the name of the folder of its pages."""
_TERM = re.compile(r"^\*\*(.+?)\*\*[:：]", re.MULTILINE)


def pages_folder() -> Path:
    """Where the pages are: beside this file, or where links are not supported, in the project."""
    beside = HERE / "pages"
    return beside if beside.is_dir() else HERE.parents[1] / "docs"


def page_path(page: str) -> Path:
    """The file of a page in the language of the window, or in English."""
    translated = pages_folder() / tr(LANGUAGE) / f"{page}.md"
    return translated if translated.is_file() else pages_folder() / f"{page}.md"


def slug(heading: str) -> str:
    """What links to a heading are called: small letters and hyphens."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def term_of(title: str) -> str:
    """The entry of the glossary, in the language of the window, that explains a title of the window; else empty."""
    wanted = tr(title).casefold()
    return next((term for term in _terms(page_path("glossary")) if wanted in _names(term)), "")


@cache
def _terms(path: Path) -> tuple[str, ...]:
    return tuple(_TERM.findall(path.read_text(encoding="utf-8")))


def _names(term: str) -> list[str]:
    """The words that an entry explains, without their symbols."""
    return [re.sub(r" \S{1,3}$", "", name).casefold() for name in re.split(r", |、", term)]
