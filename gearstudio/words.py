"""Sentences that come as English text with numbers in them, said in another language.

A language knows templates, ``"{0} is above the most of {1}; use {2}"``. A sentence is matched with them, those with
most letters first; what stands in the holes is translated in its turn.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass

ENGLISH = "en"
LANGUAGES = (ENGLISH, "de", "zh")
POINT = "."
DECIMALS = {"de": ","}
"""Decimal signs of the languages that write another one than the point."""
_HOLE = re.compile(r"\{(\d+)\}")
_QUOTE = re.compile("“[^”]*”")
_LETTER = re.compile(r"[A-Za-z]{2}")
_DEEPEST, _FEW = 8, 6
_NUMBER = re.compile(
    r"“[^“”\n]*”|„[^„“\n]*“|\"[^\"\n]*\""  # what somebody else wrote
    r"|(?<![\w.)])(?:[A-Za-z]:)?[\\/][^\n“”\"]*?\.[A-Za-z]\w*(?!\w|\.\w)"  # a path
    r"|(?<![\w.,])(?P<whole>[-−]?\d+)\.(?P<rest>\d+(?:[eE][-+−]?\d+)?)(?!\w|\.\w)"
)
Said = Callable[[str], str]
"""From an English text to what is said instead; the text itself where nothing is known."""


def noted(text: str, /) -> str:
    """The text as it is: marks a literal that is translated where it is shown."""
    return text


def with_decimal(text: str, decimal: str) -> str:
    """The numbers of a text with a language's decimal sign; versions, paths and what stands in quotes stay."""
    if decimal == POINT:
        return text
    return _NUMBER.sub(lambda found: f"{found['whole']}{decimal}{found['rest']}" if found["whole"] else found[0], text)


JOINTS = (": ", "; ", noted(" or "), noted(" and "), ", ")


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
    quoted : frozenset of int
        Holes between quotation marks: what somebody else wrote, as a line of a file, stays as it is.
    """

    text: str
    start: str
    pattern: re.Pattern[str]
    quoted: frozenset[int]


@dataclass(frozen=True)
class Speaker:
    """Says sentences in a language.

    Attributes
    ----------
    templates : tuple of Template
        In the order in which they are tried.
    sentence, word : callable
        What is said for a template or whole sentence, and for a title or a single word.
    """

    templates: tuple[Template, ...]
    sentence: Said
    word: Said

    def told(self, sentence: str, depth: int = 0) -> str:
        """A sentence, or what filled a hole of one; an unknown one stays English."""
        if depth > _DEEPEST or not _LETTER.search(sentence):
            return sentence
        return self._known(sentence) or self._filled(sentence, depth) or self._in_parts(sentence, depth) or sentence

    def _known(self, sentence: str) -> str:
        """The translation of a text without holes; empty without one."""
        title = sentence[:1].upper() + sentence[1:]
        asked = ((self.sentence, sentence), (self.word, sentence), (self.word, title))
        return next((said for say, text in asked if (said := say(text)) != text), "")

    def _filled(self, sentence: str, depth: int) -> str:
        """The translation of the first template that fits, filled in; empty when none does."""
        for template in self.templates:
            if not sentence.startswith(template.start):
                continue
            match = template.pattern.fullmatch(sentence)
            said = self.sentence(template.text) if match is not None else template.text
            if match is not None and said != template.text:
                parts = enumerate(match.groups())
                words = [part if hole in template.quoted else self.told(part, depth + 1) for hole, part in parts]
                return "".join(words[int(part)] if odd else part for part, odd in _parts(said))
        return ""

    def _in_parts(self, sentence: str, depth: int) -> str:
        """The translations of what a joint such as ": " or " or " parts, joined again; empty when there is none."""
        for joint in JOINTS:
            head, found, tail = sentence.partition(joint)
            if found:
                return self.told(head, depth + 1) + self.word(joint) + self.told(tail, depth + 1)
        return ""


def compiled(text: str) -> Template:
    """The template of a text; its holes are numbered from 0 in their order. So few words as in ``"{0} to {1}"`` stand
    between numbers alone, or they would be found in any sentence."""
    parts = _HOLE.split(text)[::2]
    hole = "(.*?)" if parts[0] or len("".join(parts)) > _FEW else "([^A-Za-z]*?)"
    quoted = frozenset(int(number) for quote in _QUOTE.findall(text) for number in _HOLE.findall(quote))
    return Template(text, parts[0], re.compile(hole.join(map(re.escape, parts))), quoted)


def in_order(texts: Iterable[str]) -> tuple[Template, ...]:
    """Templates, those with most letters outside their holes first."""
    return tuple(compiled(text) for text in sorted(texts, key=lambda text: -len(_HOLE.sub("", text))))


def _parts(text: str) -> list[tuple[str, bool]]:
    """The pieces of a template, each with whether it is the number of a hole."""
    return [(part, index % 2 == 1) for index, part in enumerate(_HOLE.split(text))]
