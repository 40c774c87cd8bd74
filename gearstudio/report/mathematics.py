"""Symbols and formulas as they are written in plain text, ``h_ae = m (hₐ* + x)``, as mathematics of the typesetter."""

from __future__ import annotations

import re

from gearstudio.report.blocks import Prose
from gearstudio.report.language import notation

_LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ", "0123456789aehijklmnoprstuvx", strict=True))
_RAISED = {"²": "2", "³": "3", "*": "*"}
_FUNCTIONS = {"sin", "cos", "tan", "cot", "arccos", "arcsin", "arctan", "min", "max"}
_LONGEST_INDEX = 3
_SHORT_WORDS = {"tip"}
_APART = "\x1f"
_WORD = r"[^\W\d_²³]{2,}(?:-[^\W\d_]{2,}|'s(?!\w))?"
_PIECES = re.compile(
    rf"(?P<text>atan2|{_WORD}(?:,? (?:{_WORD}|a)(?![\w′*]))*(?:[:;](?= ))?)"
    r"|(?P<letter>[^\W\d_²³])|(?P<number>\d+(?:\.\d+)?)|(?P<other>.)",
    re.DOTALL,
)
_ALONE, _NOT_MORE = r"(?<![^\W\d_])", r"(?![^\W\d_])"
_SYMBOLS = re.compile(rf"{_ALONE}[^\W\d_](?:_[^\W²³]+|[{''.join(_LOWERED)}]+)[²³′*]?|{_ALONE}[α-ωΑ-Ω][²³′]?{_NOT_MORE}")
_QUOTED = re.compile(r'((?<!\\)"(?:[^"\\]|\\.)*")')
_DECIMAL = re.compile(r"(?<![\w.])\d+\.\d+")
_LETTER = re.compile(r"[A-Za-zα-ωΑ-Ωℓ]")
_GREEK = re.compile(r"[α-ωΑ-Ω]+")
_PRIMED = re.compile(r"(_\([^()]*\))\s*'")
_SIGNS = {"−": "-", "·": "dot", "/": r"\/", "′": "'", "…": "dots", '"': r"\"", "#": r"\#", "$": r"\$", "\\": r"\\",
          "&": r"\&", "_": r"\_", "^": r"\^", "`": r"\`", "@": r"\@", "~": r"\~", "<": r"\<", ">": r"\>", "*": r"\*",
          "'": r"\'", ":": r"\:", "√": "√"}  # fmt: skip


def mathematics(text: str) -> str:
    """Typst mathematics of a symbol or formula; words in it stay words.

    An underscore or a lowered letter begins an index: single letters in it are slanted, words are upright. A slash
    stays a slash, so that formulas keep to their line.
    """
    parts = re.split(r"_([^\W²³]+)|([" + "".join(_LOWERED) + "]+)", text)
    made = []
    for k in range(0, len(parts), 3):
        made.append(_plain(parts[k]))
        if k + 2 < len(parts):
            named, lowered = parts[k + 1], parts[k + 2]
            made.append(f"_({_index(named or lowered)})")
    return pointed(_rooted(_PRIMED.sub(r"'\1", "".join(made))).strip())


def pointed(text: str) -> str:
    """The typesetter's mathematics with the decimal sign of the report's language."""
    return "".join(part if k % 2 else _DECIMAL.sub(_written, part) for k, part in enumerate(_QUOTED.split(text)))


def breakable(text: str) -> str:
    """The typesetter's mathematics with its phrases, where they stand in no bracket, set apart by unit separators."""
    made, depth = "", 0
    for k, part in enumerate(_QUOTED.split(text)):
        if k % 2 and " " in part and depth == 0:
            made += f"{_APART} {part[1:-1]} {_APART}"
        else:
            made, depth = made + part, depth + (0 if k % 2 else part.count("(") - part.count(")"))
    return re.sub(f"^{_APART} | {_APART}$", _APART, made)


def _written(found: re.Match[str]) -> str:
    written = notation(found.group())
    return found.group() if written == found.group() else quoted(written)


def quoted(text: str) -> str:
    """Words for the typesetter's mathematics."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def _index(text: str) -> str:
    letters = "".join(_LOWERED.get(letter, letter) for letter in text)
    if letters in _SHORT_WORDS or (letters.isalpha() and len(letters) > _LONGEST_INDEX):
        return quoted(letters)
    return " ".join(letters)


def _plain(text: str) -> str:
    made: list[str] = []
    for piece in _PIECES.finditer(text):
        kind, what = piece.lastgroup, piece.group()
        if kind == "text":
            made.append(_words(what))
        elif kind == "letter" and not _LETTER.fullmatch(what):
            made.append(quoted(what))
        elif kind == "other" and what in _RAISED:
            made.append(f"^{_RAISED[what]}")
        elif kind == "other":
            made.append(_SIGNS.get(what, what))
        else:
            made.append(what)
    return _spaced(made)


def _words(text: str) -> str:
    if text == "atan2":
        return f"op({quoted(text)})"
    words = text.split(" ")
    if all(word in _FUNCTIONS for word in words):
        return " ".join(words)
    if words[0] in _FUNCTIONS:
        return f"{words[0]} {_words(' '.join(words[1:]))}"
    return " ".join(text) if _GREEK.fullmatch(text) else quoted(text)


def _spaced(pieces: list[str]) -> str:
    """Pieces apart from each other, an index or a power at what it belongs to."""
    made = ""
    for piece in pieces:
        made += piece if piece.startswith(("^", "'", " ")) or not made else f" {piece}"
    return made


def _rooted(text: str) -> str:
    """A root sign with the bracket after it as a root over what is in the bracket."""
    start = text.find("√")
    if start < 0:
        return text
    open_ = text.find("(", start)
    depth = 0
    for k in range(open_, len(text)):
        depth += {"(": 1, ")": -1}.get(text[k], 0)
        if depth == 0:
            return f"{text[:start]}sqrt{text[open_ : k + 1]}{_rooted(text[k + 1 :])}"
    return text


def prose(text: str) -> Prose:
    """A sentence with the symbols in it set as mathematics."""
    parts: list[tuple[str, str]] = []
    end = 0
    for found in _SYMBOLS.finditer(text):
        if found.start() > end:
            parts.append(("text", text[end : found.start()]))
        parts.append(("mathematics", mathematics(found.group())))
        end = found.end()
    if end < len(text):
        parts.append(("text", text[end:]))
    return tuple(parts)
