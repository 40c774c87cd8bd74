"""The window's words in the language that the user chose."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

from gearstudio.words import noted as noted

CONTEXT = "GearStudio"


def tr(text: str, /, **values: object) -> str:
    """A text in the chosen language, its ``{names}`` filled in.

    The text is a literal in English, or an entry of a table of such literals; `tools/translations.py` collects both
    for the translation files.
    """
    said = QCoreApplication.translate(CONTEXT, text) if text else ""
    return said.format(**values) if values else said


def inline(text: str, /) -> str:
    """A title within a sentence: in small letters in English, as it is in languages that write nouns with capitals."""
    said = tr(text)
    return said.lower() if said == text else said


def told(message: object, /) -> str:
    """A sentence of the core (an issue, an error, a stage) in the chosen language; an unknown one stays English."""
    from ui.sentences import translated

    return "\n".join(translated(line) for line in str(message).split("\n"))
