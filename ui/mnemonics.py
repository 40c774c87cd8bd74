"""One letter for each entry of a menu: translators cannot see which letters its other entries have."""

from __future__ import annotations

import re
from collections.abc import Sequence
from string import ascii_uppercase

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton

APART = re.compile(r"\(&(.)\)")
"""The mark of languages without letters of their own: 保存(&S)."""
_WORD = re.compile(r"[^\W\d_]+")


def mark(text: str) -> str:
    """The letter that calls an entry; empty when none does."""
    at = text.replace("&&", "  ").find("&")
    return text[at + 1].upper() if 0 <= at < len(text) - 1 else ""


def distinct(texts: Sequence[str]) -> list[str]:
    """The texts with marks at letters of their own: the first with a letter keeps it, others take what is free.

    A text without a mark stays without one; one that finds no free letter loses its mark.
    """
    taken: set[str] = set()
    keepers = []
    for text in texts:
        keepers.append(mark(text) not in taken)
        taken.add(mark(text))
    made = list(texts)
    for number, text in enumerate(texts):
        if not mark(text) or keepers[number]:
            continue
        apart = APART.search(text)
        letters = ascii_uppercase if apart else _letters(text)
        letter = next((one for one in letters if one.upper() not in taken), "")
        taken.add(letter.upper())
        if apart:
            made[number] = text.replace(apart[0], f"(&{letter})" if letter else "")
        else:
            made[number] = _marked(text, letter)
    return made


def separate(entries: Sequence[QAction | QAbstractButton]) -> None:
    """Give the entries of a menu, or the buttons of a dialog, letters of their own."""
    for entry, text in zip(entries, distinct([entry.text() for entry in entries]), strict=True):
        if text != entry.text():
            entry.setText(text)


def _letters(text: str) -> list[str]:
    """Letters to choose from, the first ones of words before the others."""
    words = _WORD.findall(text.replace("&", ""))
    return [word[0] for word in words] + [letter for word in words for letter in word[1:]]


def _marked(text: str, letter: str) -> str:
    plain = re.sub(r"&(?!&)(?<!&&)", "", text)
    if not letter:
        return plain
    starts = [match.start() for match in _WORD.finditer(plain) if match[0][0] == letter]
    at = starts[0] if starts else plain.index(letter)
    return f"{plain[:at]}&{plain[at:]}"
