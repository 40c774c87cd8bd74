"""What the pages are made of: headings, paragraphs, tables, figures, equations; plain records for the typesetter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

Prose = tuple[tuple[str, str], ...]
"""Words and mathematics in turn, as pairs of ``"text"`` or ``"mathematics"`` and the content."""


@dataclass(frozen=True)
class Text:
    """A paragraph."""

    text: str
    kind: str = "text"


@dataclass(frozen=True)
class Heading:
    """A heading inside a section."""

    text: str
    kind: str = "heading"


@dataclass(frozen=True)
class Table:
    """A table as wide as the text.

    Attributes
    ----------
    header : tuple of str
    rows : tuple of tuple of str
        A row with a single cell is a heading across the table.
    align : str
        One letter for each column: ``l``, ``r`` or ``c``; ``d`` for numbers with their points below each other,
        ``m`` for typst mathematics, ``k`` for words of files.
    shares : tuple of float
        How the columns share the room that is left: 0 for one as wide as what is in it.
    """

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    align: str
    shares: tuple[float, ...] = (1.0,)
    kind: str = "table"


@dataclass(frozen=True)
class Picture:
    """A figure: the file's name beside the document, its caption, its width as part of the text's."""

    file: str
    caption: str
    width: float = 1.0
    kind: str = "picture"


@dataclass(frozen=True)
class Formula:
    """An equation with its numbers: of each member what went in and came out, symbol and value each."""

    title: str
    number: str
    used: str
    printed: str
    meaning: Prose
    departure: Prose
    numbers: tuple[tuple[str, tuple[str, ...]], ...]
    kind: str = "formula"


Block = Text | Heading | Table | Picture | Formula


@dataclass(frozen=True)
class Chapter:
    """A section of the report with its blocks."""

    key: str
    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Pages:
    """The whole report: what stands on the first page, the chapters, and the files of the figures by name.

    Attributes
    ----------
    language : str
        Its code.
    words : mapping of str to str
        What the template itself says.
    warnings : tuple of str
        What whoever asked for the report should know, in English.
    """

    title: str
    facts: tuple[tuple[str, str], ...]
    chapters: tuple[Chapter, ...]
    files: dict[str, bytes] = field(default_factory=dict)
    cover: Picture | None = None
    language: str = "en"
    words: dict[str, str] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()

    def data(self) -> dict[str, Any]:
        """For the typesetter, without the figures' contents."""
        cover = None if self.cover is None else asdict(self.cover)
        chapters = [asdict(one) for one in self.chapters]
        return {
            "title": self.title, "facts": self.facts, "chapters": chapters, "cover": cover,
            "language": self.language, "words": self.words,
        }  # fmt: skip


def rows(table: Sequence[Sequence[str]]) -> tuple[tuple[str, ...], ...]:
    """Rows as a `Table` takes them."""
    return tuple(tuple(row) for row in table)
