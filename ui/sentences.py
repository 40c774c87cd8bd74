"""Sentences of the core, which come as English text with numbers in them, in the language of the window."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from gearstudio.words import Speaker, Template, in_order
from ui.formatting import written
from ui.units import in_sentence
from ui.words import tr

SENTENCES = "Sentences"
TEMPLATES = Path(__file__).parent / "translations" / "sentences.json"


def translated(sentence: str) -> str:
    """A sentence in the language, notation and unit of length of the window; an unknown one stays English."""
    return written(in_sentence(Speaker(templates(), _said, tr).told(sentence)))


def _said(text: str) -> str:
    return QCoreApplication.translate(SENTENCES, text)


@cache
def templates() -> tuple[Template, ...]:
    """All templates, those with most letters outside their holes first."""
    texts: list[str] = json.loads(TEMPLATES.read_text(encoding="utf-8"))
    return in_order(texts)
