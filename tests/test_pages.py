"""Guide and glossary say the same in all languages: structure, pictures, code, keys, numbers, words of the window."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import pytest

from tools import translations

DOCS = Path(__file__).resolve().parents[1] / "docs"
LANGUAGES = tuple(translations.LANGUAGES)
PAGES = ("guide", "glossary")
KEYS = {"Strg": "Ctrl", "Umschalt": "Shift"}
EMPHASIS = re.compile(r"(?<!\*)\*([^*\n]+)\*(?!\*)")


def text(page: str, language: str = "") -> str:
    return (DOCS / language / f"{page}.md").read_text(encoding="utf-8")


def without_code(page: str) -> str:
    return re.sub(r"`[^`\n]*`", "", re.sub(r"```.*?```", "", page, flags=re.DOTALL))


def emphasised(page: str) -> list[str]:
    """What is emphasised, which are mostly titles of the window."""
    return EMPHASIS.findall(without_code(page))


def digits(page: str) -> Counter[str]:
    """The numbers outside code, with decimal points."""
    return Counter(re.findall(r"\d+(?:\.\d+)?", re.sub(r"(?<=\d),(?=\d)", ".", without_code(page))))


def tables(page: str) -> list[list[list[str]]]:
    """The tables of a page: rows of cells; the second row parts the head from the body."""
    found = re.findall(r"(?:^\|.*\|\n?)+", page, flags=re.MULTILINE)
    return [[row.strip("|").split("|") for row in table.strip().split("\n")] for table in found]


def plain(title: str) -> str:
    """A title of the window without mnemonic and dots."""
    return re.sub(r"\(&\w\)|&|…$", "", title).rstrip("…").strip()


def slug(heading: str) -> str:
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("page", PAGES)
def test_pages_have_the_same_structure(page: str, language: str) -> None:
    english, other = text(page), text(page, language)
    for pattern in (r"^#+", r"^- ", r"^\*\*.+?\*\*[:：]"):
        first, second = (re.findall(pattern, one, flags=re.MULTILINE) for one in (english, other))
        assert len(first) == len(second) and (first == second or pattern.endswith("]")), pattern
    sizes = [[len(row) for row in table] for table in tables(english)]
    assert [[len(row) for row in table] for table in tables(other)] == sizes
    pictures = re.findall(r"\]\((images/[^)]+)\)", english)
    assert re.findall(r"\]\(\.\./(images/[^)]+)\)", other) == pictures
    assert all((DOCS / picture).is_file() for picture in pictures)
    blocks = re.findall(r"```.*?```", english, flags=re.DOTALL)
    assert re.findall(r"```.*?```", other, flags=re.DOTALL) == blocks


@pytest.mark.parametrize("language", LANGUAGES)
def test_code_keys_and_numbers_are_the_same(language: str) -> None:
    english, other = text("guide"), text("guide", language)
    codes = [
        Counter(re.findall(r"`[^`\n]+`", re.sub(r"```.*?```", "", one, flags=re.DOTALL))) for one in (english, other)
    ]
    assert codes[0] == codes[1]
    for first, second in zip(tables(english), tables(other), strict=True):
        if "F2" in str(first) or "Ctrl" in str(first):
            keys = [re.sub(r"Strg|Umschalt", lambda key: KEYS[key.group()], row[0]) for row in second[2:]]
            assert keys == [row[0] for row in first[2:]]
        for row, translated in zip(first, second, strict=True):
            assert digits(" ".join(row)) == digits(" ".join(translated)), translated
    assert digits(english) == digits(other)


@pytest.mark.parametrize("language", LANGUAGES)
def test_words_of_the_window_are_those_of_the_window(language: str) -> None:
    words = translations.read_ts(translations.ts_path(language))[translations.WORDS]
    said: dict[str, set[str]] = {}
    for source, translation in words.items():
        said.setdefault(plain(source).casefold(), set()).add(plain(translation).casefold())
    known, used = said.keys(), {plain(one).casefold() for one in emphasised(text("guide", language))}
    for titles in emphasised(text("guide")):
        parts = [plain(part).casefold() for part in titles.split(" ▸ ")]
        if all(part in known for part in parts):
            expected = [said[part] for part in parts]
            assert any(
                len(one.split(" ▸ ")) == len(parts)
                and all(plain(word) in choice for word, choice in zip(one.split(" ▸ "), expected, strict=True))
                for one in used
            ), f"{titles}: {expected}"


@pytest.mark.parametrize("language", ["", *LANGUAGES])
def test_links_within_the_guide_lead_to_its_headings(language: str) -> None:
    page = text("guide", language)
    headings = {slug(heading) for heading in re.findall(r"^#+ (.+)$", page, flags=re.MULTILINE)}
    targets = re.findall(r"\]\(#([^)]+)\)", page)
    assert len(targets) == page.count("\n## ") and set(targets) <= headings


@pytest.mark.parametrize("language", ["", *LANGUAGES])
def test_every_term_is_explained_once(language: str) -> None:
    terms = re.findall(r"^\*\*(.+?)\*\*[:：]", text("glossary", language), flags=re.MULTILINE)
    assert len(terms) == len(set(terms)) > 40
