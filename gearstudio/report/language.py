"""The language that a report is written in: its words, and how it writes numbers and dates.

While `speaking` holds, `tr` and its like say everything in that language. The catalogues beside this file are made from
the window's translation files; a text that is in none of them stays English.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from datetime import datetime
from functools import cache, cached_property
from importlib import resources

from gearstudio.words import DECIMALS, ENGLISH, POINT, Speaker, in_order, noted, with_decimal

CJK = {"zh"}
"""Languages whose characters are in no font that the program brings."""
_MINUS = "\N{MINUS SIGN}"
_MOMENTS = {"de": "%d.%m.%Y, %H:%M %Z", "zh": "%Y年%m月%d日 %H:%M %Z"}
_NEGATIVE = re.compile(r"-(?=\d)")


@dataclass(frozen=True)
class Language:
    """Translations by English text, of words and of templates of sentences, and the decimal sign."""

    code: str = ENGLISH
    words: Mapping[str, str] = field(default_factory=dict)
    sentences: Mapping[str, str] = field(default_factory=dict)
    decimal: str = POINT

    def word(self, text: str) -> str:
        """A title or a word; as it is when it is not known."""
        return self.words.get(text, text)

    def told(self, sentence: str) -> str:
        """A sentence with numbers in it."""
        return "\n".join(self._speaker.told(line) for line in sentence.split("\n"))

    @cached_property
    def _speaker(self) -> Speaker:
        return Speaker(in_order(self.sentences), lambda text: self.sentences.get(text, text), self.word)


_ENGLISH = Language()


@cache
def language(code: str) -> Language:
    """The language of a code, with its catalogue read."""
    if code == ENGLISH:
        return _ENGLISH
    text = (resources.files("gearstudio.report") / "words" / f"{code}.json").read_text(encoding="utf-8")
    return Language(code, **json.loads(text), decimal=DECIMALS.get(code, POINT))


_current: ContextVar[Language] = ContextVar("language of the report")


@contextmanager
def speaking(spoken: Language) -> Iterator[None]:
    """Say everything in a language meanwhile."""
    token = _current.set(spoken)
    try:
        yield
    finally:
        _current.reset(token)


def spoken() -> Language:
    """The language that is spoken now."""
    return _current.get(_ENGLISH)


def tr(text: str, /, **values: object) -> str:
    """A text in the language of the report, its ``{names}`` filled in.

    The text is a literal in English, or an entry of a table of such literals.
    """
    said = spoken().word(text) if text else ""
    return said.format(**values) if values else said


def inline(text: str, /) -> str:
    """A title within a sentence: in small letters in English, as it is in languages that write nouns with capitals."""
    said = tr(text)
    return said[:1].lower() + said[1:] if spoken().code == ENGLISH else said


def told(message: object, /) -> str:
    """A sentence of the core (an issue, an error) with its numbers."""
    return notation(spoken().told(str(message)))


def number(value: float, spec: str = ".10g") -> str:
    """A number formatted in Python's way, then written in the language's."""
    return notation(f"{value:{spec}}")


def notation(text: str) -> str:
    """The numbers of a text with the language's decimal sign and a true minus sign; versions and paths stay."""
    pointed = with_decimal(text, spoken().decimal)
    return _NEGATIVE.sub(_MINUS, pointed) if re.fullmatch(r"-[\d.,]+(e[-+]?\d+)?", pointed) else pointed


def moment(when: datetime) -> str:
    """A date with the time of day."""
    return when.strftime(_MOMENTS.get(spoken().code, "%Y-%m-%d %H:%M %Z"))


MEMBERS_SAID = {"pinion": noted("Pinion"), "wheel": noted("Wheel")}
FLANKS_SAID = {"concave": noted("Concave flank"), "convex": noted("Convex flank")}
DIRECTIONS_SAID = {"drive": noted("Drive"), "coast": noted("Coast")}
VARIANTS_SAID = {"published": noted("Published"), "optimised": noted("Optimised")}
