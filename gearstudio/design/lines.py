"""What is wrong with the lines of a design file that cannot be read, and what to write instead."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator

MOST_LINES = 20
"""After so many bad lines the others are not looked for."""
_LONGEST_LINE, _LONGEST_WORD = 60, 30
_ENTRY = re.compile(r"\s*([\w.\"'-]+)\s*=(?!=)\s*(.*?)\s*")
_HEADING = re.compile(r"\s*\[")
_DECIMAL_COMMA = re.compile(r"([+-]?\d+),(\d+(?:[eE][+-]?\d+)?)")
_HALF = re.compile(r"([+-]?)(\d*)\.(\d*)")
_WITH_UNIT = re.compile(r"([+-]?\d+(?:[.,]\d+)?)\s*(mm|µm|um|°|deg|in|\"|″|%)")
_WORD = re.compile(r"[“”„«»‘’]?([^\W\d_]\w*)[“”„«»‘’]?")


def bad_lines(text: str) -> Iterator[str]:
    """Problems of the lines, each with its number and itself: ``line 3, “outer_module = 3,5”: …``.

    `MOST_LINES` at most. A design file has one heading, entry or comment to a line, so that each can be read by itself.
    """
    found = 0
    given: dict[str, int] = {}
    table = ""
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        entry = _ENTRY.fullmatch(line)
        name = f"{table}.{entry[1]}".strip(".") if entry else ""
        what = _problem(line)
        if not what and _HEADING.match(line):
            name = table = line.partition("#")[0].strip().strip("[]").strip()
        if not what and name in given:
            what = f"“{name}” stands in line {given[name]} too; keep one of them"
        given.setdefault(name, number)
        if what:
            yield f"line {number}, “{shortened(line.strip())}”: {what}"
            found += 1
        if found == MOST_LINES:
            return


def shortened(text: str, most: int = _LONGEST_LINE) -> str:
    """A piece of a file fit for a message: on one line, printable and not too long."""
    plain = "".join(letter if letter.isprintable() else "\N{REPLACEMENT CHARACTER}" for letter in text[: most + 1])
    return plain if len(plain) <= most else plain[: most - 1] + "…"


def _problem(line: str) -> str:
    """What is wrong with a line; empty when it can be read."""
    try:
        tomllib.loads(line)
    except (ValueError, RecursionError):
        pass
    else:
        return ""
    if _HEADING.match(line):
        return "the heading of a table stands alone on its line and between brackets, as “[pair]”"
    entry = _ENTRY.fullmatch(line)
    if entry is None:
        return "this is no heading of a table, as “[pair]”, no entry, as “pinion_teeth = 17”, and no comment after #"
    value = entry[2] if entry[2][:1] in "\"'“„" else entry[2].partition("#")[0].strip()
    return _problem_of_value(shortened(entry[1], _LONGEST_WORD), value)


def _problem_of_value(key: str, value: str) -> str:
    if not value:
        return f"the value after the sign = is missing; put it there, or take the line out to have the usual “{key}”"
    if match := _DECIMAL_COMMA.fullmatch(value):
        return f"numbers in a design file have a point, not a comma; write “{key} = {match[1]}.{match[2]}”"
    if match := _WITH_UNIT.fullmatch(value):
        number = match[1].replace(",", ".")
        return f"a number stands without a unit, which is always the same; write “{key} = {number}”"
    if (match := _HALF.fullmatch(value)) and (match[2] or match[3]):
        number = f"{match[1]}{match[2] or 0}.{match[3] or 0}"
        return f"a number needs digits on both sides of its point; write “{key} = {number}”"
    if match := _WORD.fullmatch(value):
        word = shortened(match[1], _LONGEST_WORD)
        return f'a word needs straight quotation marks; write “{key} = "{word}"”'
    if value[0] in "\"'“„" and (len(value) == 1 or value[-1] not in "\"'"):
        return "a text needs two straight quotation marks on one line"
    return "the value is neither a number, as “3.5”, nor a text between straight quotation marks"
