"""A small reader of ISO 10303-21 text, written from the grammar alone: no kernel stands behind it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

_TOKEN = re.compile(
    r"(?P<space>\s+|/\*.*?\*/)"
    r"|'(?P<text>(?:[^']|'')*)'"
    r"|\#(?P<ref>\d+)"
    r"|\.(?P<enum>[A-Z_0-9]+)\."
    r"|(?P<real>[+-]?\d+\.\d*(?:E[+-]?\d+)?)"
    r"|(?P<int>[+-]?\d+)"
    r"|(?P<word>[A-Z][A-Z_0-9\-]*)"
    r"|(?P<mark>[()=,;$*])",
    re.S,
)
_WIDE = re.compile(r"\\X2\\((?:[0-9A-F]{4})+)\\X0\\")


@dataclass(frozen=True)
class Ref:
    """``#12``."""

    number: int


@dataclass(frozen=True)
class Enum:
    """``.MILLI.``"""

    name: str


@dataclass(frozen=True)
class Entity:
    """An instance, of one type or of several at once; values by type."""

    parts: dict[str, list[Any]]

    @property
    def kind(self) -> str:
        return next(iter(self.parts)) if len(self.parts) == 1 else ""

    @property
    def values(self) -> list[Any]:
        return next(iter(self.parts.values()))


@dataclass
class StepText:
    """A file: its header by keyword, its instances by number."""

    header: dict[str, list[Any]] = field(default_factory=dict)
    data: dict[int, Entity] = field(default_factory=dict)

    def all(self, kind: str) -> list[tuple[int, Entity]]:
        """Instances that have a type, alone or among others."""
        return [(number, entity) for number, entity in self.data.items() if kind in entity.parts]

    def get(self, ref: Ref) -> Entity:
        return self.data[ref.number]


def refs(value: Any) -> Iterator[int]:
    """Numbers of the instances that values name."""
    if isinstance(value, Ref):
        yield value.number
    elif isinstance(value, list | tuple):
        for part in value:
            yield from refs(part)


def parse(text: str) -> StepText:
    """Read a whole file; AssertionError where the grammar is broken."""
    tokens = list(_tokens(text))
    found, at = StepText(), 0

    def take(kind: str, value: Any = None) -> Any:
        nonlocal at
        assert at < len(tokens), "the text ends in the middle of an instance"
        have = tokens[at]
        assert have[0] == kind and (value is None or have[1] == value), f"{have} where {kind} {value} should be"
        at += 1
        return have[1]

    def values() -> list[Any]:
        nonlocal at
        take("mark", "(")
        got: list[Any] = []
        while tokens[at] != ("mark", ")"):
            if got:
                take("mark", ",")
            got.append(value())
        at += 1
        return got

    def value() -> Any:
        nonlocal at
        kind, content = tokens[at]
        if (kind, content) == ("mark", "("):
            return values()
        at += 1
        if kind == "word":
            return (content, values())
        assert kind != "mark" or content in "$*", f"{content} where a value should be"
        return None if kind == "mark" else content

    def typed() -> dict[str, list[Any]]:
        nonlocal at
        if tokens[at] != ("mark", "("):
            return {take("word"): values()}
        at += 1
        parts: dict[str, list[Any]] = {}
        while tokens[at] != ("mark", ")"):
            word = take("word")
            parts[word] = values()
        at += 1
        return parts

    for word in ("ISO-10303-21", "HEADER"):
        take("word", word), take("mark", ";")
    while tokens[at] != ("word", "ENDSEC"):
        found.header |= typed()
        take("mark", ";")
    for word in ("ENDSEC", "DATA"):
        take("word", word), take("mark", ";")
    while tokens[at] != ("word", "ENDSEC"):
        number = take("ref").number
        assert number not in found.data, f"#{number} is there twice"
        take("mark", "=")
        found.data[number] = Entity(typed())
        take("mark", ";")
    for word in ("ENDSEC", "END-ISO-10303-21"):
        take("word", word), take("mark", ";")
    assert at == len(tokens)
    return found


def _tokens(text: str) -> Iterator[tuple[str, Any]]:
    at = 0
    while at < len(text):
        match = _TOKEN.match(text, at)
        assert match, f"no token at {text[at : at + 40]!r}"
        at, kind = match.end(), str(match.lastgroup)
        content = match[kind]
        if kind == "text":
            yield kind, _WIDE.sub(lambda m: bytes.fromhex(m[1]).decode("utf-16-be"), content.replace("''", "'"))
        elif kind == "ref":
            yield kind, Ref(int(content))
        elif kind == "enum":
            yield kind, Enum(content)
        elif kind in ("real", "int"):
            yield kind, float(content) if kind == "real" else int(content)
        elif kind != "space":
            yield kind, content
