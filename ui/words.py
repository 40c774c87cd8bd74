"""The window's words in the language that the user chose."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication

CONTEXT = "GearStudio"


def tr(text: str, /, **values: object) -> str:
    """A text in the chosen language, its ``{names}`` filled in.

    The text is a literal in English; the translation files are made from these literals.
    """
    said = QCoreApplication.translate(CONTEXT, text)
    return said.format(**values) if values else said
