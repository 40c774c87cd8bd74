"""The window's words in the language that the user chose."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial, wraps
from string import Formatter
from typing import Any, ParamSpec

from PySide6.QtCore import QCoreApplication

from gearstudio.words import with_decimal
from ui.language import decimal

CONTEXT = "GearStudio"
_Given = ParamSpec("_Given")


class Said(str):
    """A text that remembers how it came about, so that `told` can say it again after a change of language."""

    __slots__ = ("again",)
    again: Callable[[], str]

    def __reduce__(self) -> tuple[type[str], tuple[str]]:
        return str, (str(self),)  # other processes take the words as they are


class _Filler(Formatter):
    """Fills in texts; numbers with decimals get the language's sign."""

    def format_field(self, value: Any, format_spec: str) -> str:
        text = str(super().format_field(value, format_spec))
        return with_decimal(text, decimal()) if isinstance(value, float) else text


_filler = _Filler()


def tr(text: str, /, **values: object) -> str:
    """A text in the chosen language, its ``{names}`` filled in, numbers as the language writes them.

    The text is a literal in English, or an entry of a table of such literals; `tools/translations.py` collects both
    for the translation files.
    """
    said = QCoreApplication.translate(CONTEXT, text) if text else ""
    return _remembered(_filler.format(said, **values) if values else said, partial(_tr_again, text, values))


def noted(text: str, /) -> str:
    """The text as it is: marks a literal that is translated where it is shown."""
    return text


def inline(text: str, /) -> str:
    """A title within a sentence: in small letters in English, as it is in languages that write nouns with capitals."""
    said = tr(text)
    return _remembered(said.lower() if said == text else said, partial(inline, text))


def told(message: object, /) -> str:
    """A sentence of the core (an issue, an error, a stage) in the chosen language; an unknown one stays English.

    What was said before (`Said`), also in another language, is said again in the present one.
    """
    from ui.sentences import translated

    if isinstance(message, Said):
        return message.again()
    lines = str(message).split("\n")
    return _remembered("\n".join(translated(line) for line in lines), partial(told, "\n".join(lines)))


def retold(make: Callable[_Given, str]) -> Callable[_Given, str]:
    """For a function that puts words together: what it returns can be said again, by calling it again."""

    @wraps(make)
    def made(*args: _Given.args, **kwargs: _Given.kwargs) -> str:
        return _remembered(make(*args, **kwargs), partial(made, *args, **kwargs))

    return made


def _tr_again(text: str, values: dict[str, object]) -> str:
    return tr(text, **{name: told(value) if isinstance(value, Said) else value for name, value in values.items()})


def _remembered(text: str, again: Callable[[], str]) -> str:
    said = Said(text)
    said.again = again
    return said
