"""Sentences of the core, which come as English text with numbers in them, in the language of the window.

The translation files have a template for each of them, ``"{0} is above the most of {1}; use {2}"``. A sentence is
matched with the templates, those with most letters first; what stands in the holes is translated in its turn.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from ui.words import noted, tr

SENTENCES = "Sentences"
TEMPLATES = Path(__file__).parent / "translations" / "sentences.json"
_HOLE = re.compile(r"\{(\d+)\}")
_DEEPEST = 8
JOINTS = (": ", "; ", noted(" or "), noted(" and "), ", ")
_LETTER = re.compile(r"[A-Za-z]{2}")


@dataclass(frozen=True)
class Template:
    """A sentence with holes, and how to find it.

    Attributes
    ----------
    text : str
    start : str
        What comes before the first hole: a quick test.
    pattern : re.Pattern
        Matches whole sentences; a group for each hole.
    """

    text: str
    start: str
    pattern: re.Pattern[str]


def translated(sentence: str, depth: int = 0) -> str:
    """A sentence, or what filled a hole of one, in the language of the window."""
    if depth > _DEEPEST or not _LETTER.search(sentence):
        return sentence
    return _known(sentence) or _filled(sentence, depth) or _in_parts(sentence, depth) or sentence


def _known(sentence: str) -> str:
    """The translation of a text without holes; empty without one."""
    title = sentence[:1].upper() + sentence[1:]
    for said, text in (
        (QCoreApplication.translate(SENTENCES, sentence), sentence),
        (tr(sentence), sentence),
        (tr(title), title),
    ):
        if said != text:
            return said
    return ""


def _filled(sentence: str, depth: int) -> str:
    """The translation of the first template that fits, filled in; empty when none does."""
    for template in templates():
        if not sentence.startswith(template.start):
            continue
        match = template.pattern.fullmatch(sentence)
        said = QCoreApplication.translate(SENTENCES, template.text) if match is not None else template.text
        if match is not None and said != template.text:
            words = [translated(part, depth + 1) for part in match.groups()]
            return "".join(words[int(part)] if odd else part for part, odd in _parts(said))
    return ""


def _in_parts(sentence: str, depth: int) -> str:
    """The translations of what a joint such as ": " or " or " parts, joined again; empty when there is no joint."""
    for joint in JOINTS:
        head, found, tail = sentence.partition(joint)
        if found:
            return translated(head, depth + 1) + tr(joint) + translated(tail, depth + 1)
    return ""


@cache
def templates() -> tuple[Template, ...]:
    """All templates, those with most letters outside their holes first."""
    texts: list[str] = json.loads(TEMPLATES.read_text(encoding="utf-8"))
    return tuple(compiled(text) for text in sorted(texts, key=lambda text: -len(_HOLE.sub("", text))))


def compiled(text: str) -> Template:
    """The template of a text; its holes are numbered from 0 in their order."""
    parts = _HOLE.split(text)[::2]
    return Template(text, parts[0], re.compile("(.*?)".join(map(re.escape, parts))))


def _parts(text: str) -> list[tuple[str, bool]]:
    """The pieces of a template, each with whether it is the number of a hole."""
    return [(part, index % 2 == 1) for index, part in enumerate(_HOLE.split(text))]
