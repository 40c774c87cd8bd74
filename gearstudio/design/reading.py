"""The text of a design file as tables, or in plain words why it is none."""

from __future__ import annotations

import codecs
import re
import tomllib
from functools import cache
from typing import Any

from gearstudio.design.lines import bad_lines
from gearstudio.design.model import all_field_specs
from gearstudio.errors import DesignError, Issue

_KINDS = (
    (b"\x89PNG", "a picture (PNG)"),
    (b"\xff\xd8\xff", "a picture (JPEG)"),
    (b"GIF8", "a picture (GIF)"),
    (b"%PDF", "a document (PDF)"),
    (b"PK\x03\x04", "an archive (ZIP), as 3MF models and office documents are"),
    (b"ISO-10303-21", "a model (STEP)"),
    (b"glTF", "a model (GLB)"),
    (b"solid ", "a model (STL)"),
)
_WIDE = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
_BINARY = re.compile(rb"[\x00-\x08\x0e-\x1f]")
_CHOOSE = "choose a file that GearStudio saved, NAME.gear.toml"


def design_tables(content: bytes, path: object = "") -> dict[str, Any]:
    """Tables and keys of a design file.

    Parameters
    ----------
    content : bytes
        Of the file.
    path : object
        Its name, for the error.

    Raises
    ------
    DesignError
        It is no design file, with the reason; or some of its lines cannot be read, with each of them.
    """
    text = _text(content, path)
    if not text.strip():
        raise _unusable("empty", path, f"the file is empty and holds no design; {_CHOOSE}, or an earlier copy of it")
    if not _has_known_names(text):
        raise _unusable("no_design", path, f"nothing in it belongs to a design of GearStudio; {_CHOOSE}")
    try:
        return tomllib.loads(text)
    except RecursionError as error:
        raise _unusable("not_toml", path, "tables or lists in it are nested too deeply for a design") from error
    except tomllib.TOMLDecodeError as error:
        found = list(bad_lines(text)) or [_somewhere(str(error))]
        raise _unusable("not_toml", path, *found) from error
    except ValueError as error:  # more digits than Python converts
        raise _unusable("not_toml", path, "a number in it has thousands of digits") from error


def _text(content: bytes, path: object) -> str:
    for start, kind in _KINDS:
        if content.startswith(start):
            raise _unusable("no_design", path, f"this is {kind}, no design of GearStudio; {_CHOOSE}")
    if content.startswith(_WIDE):
        raise _unusable("not_utf8", path, "the text is not UTF-8 but UTF-16; save the file as UTF-8 in your editor")
    if _BINARY.search(content):
        raise _unusable("no_design", path, f"this is no text, so no design of GearStudio; {_CHOOSE}")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        text = f"line {line} is not UTF-8 text; save the file as UTF-8 in your editor"
        raise _unusable("not_utf8", path, text) from error


def _somewhere(said: str) -> str:
    """Of a file whose lines can all be read by themselves."""
    place = re.search(r"line (\d+)", said)
    if place is None:
        return "it cannot be read to its end; compare it with a design that GearStudio saved"
    return f"it cannot be read from line {place[1]} on; compare it with a design that GearStudio saved"


def _has_known_names(text: str) -> bool:
    """Whether any line begins as one of a design file does."""
    return _known_names().search(text) is not None


@cache
def _known_names() -> re.Pattern[str]:
    names = {part for path in all_field_specs() for part in path.split(".")} | {"format"}
    known = "|".join(sorted(names - {"name"}))  # every other TOML file has a name too
    return re.compile(rf"^[\s\[\"']*(?:{known})\b", re.MULTILINE)


def _unusable(code: str, path: object, *messages: str) -> DesignError:
    return DesignError([Issue(code, "", message) for message in messages], path)
