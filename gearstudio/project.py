"""Design files: ``NAME.gear.toml``, read with every problem named and written as a whole."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches
from pathlib import Path

from gearstudio.design import FORMAT, Design, FieldSpec, all_field_specs, field_value
from gearstudio.design.reading import design_tables
from gearstudio.errors import DesignError, FileError, Issue
from gearstudio.files import read_bytes, write_text
from gearstudio.presets import PRESETS_BY_KEY
from gearstudio.validation import PATIENCE_S, read_design

PRESET_PREFIX = "preset:"
LARGEST_FILE = 1_000_000
_NO_FORMAT = f"the number of the format is missing; write format = {FORMAT} in the first line"


def open_design(name: str) -> Design:
    """The design of a file's path, or of a preset's key as ``preset:KEY``.

    Raises
    ------
    FileError
        The file cannot be read, or there is no such preset.
    DesignError
        As `load_design`.
    """
    if not name.startswith(PRESET_PREFIX):
        return load_design(name)
    key = name.removeprefix(PRESET_PREFIX)
    if key not in PRESETS_BY_KEY:
        near = get_close_matches(key, PRESETS_BY_KEY, 1, 0.0)
        raise FileError(
            name, f"no such preset; the nearest is {PRESET_PREFIX}{near[0]}; presets: {', '.join(PRESETS_BY_KEY)}"
        )
    return PRESETS_BY_KEY[key].design


def load_design(path: str | Path, patience_s: float = PATIENCE_S) -> Design:
    """Read a design file; ``patience_s`` as of `validation.check`.

    Raises
    ------
    FileError
        It is missing, a folder, not permitted or far too large.
    DesignError
        It is no design file, or holds an unusable design; carries every problem found.
    """
    path = Path(path)
    if path.exists() and not path.is_file() and not path.is_dir():
        raise FileError(path, "this is a device, not a file")
    content = read_bytes(path)
    if len(content) > LARGEST_FILE:
        raise FileError(path, f"{len(content) / 1e6:.3g} MB is too large for a design file; the most is 1 MB")
    data = design_tables(content, path)
    missing = [] if "format" in data else [Issue("no_format", "format", _NO_FORMAT)]
    design, issues = read_design(data, patience_s)
    if design is None or missing:
        raise DesignError([*missing, *(issue for issue in issues if issue.severity == "error")], path)
    return design


def save_design(path: str | Path, design: Design) -> None:
    """Write a design file that `load_design` reads back as the same design.

    Raises
    ------
    FileError
        It cannot be written there; what was there before is untouched.
    """
    write_text(Path(path), design_text(design))


def design_text(design: Design) -> str:
    """The design file of a design, with units and choices as comments."""
    return "\n".join(_lines(design)) + "\n"


def _lines(design: Design) -> Iterator[str]:
    yield f"format = {FORMAT}"
    table = ""
    for path, spec in all_field_specs().items():
        value = field_value(design, path)
        head, _, key = path.rpartition(".")
        if head != table:
            table = head
            yield ""
            yield f"[{table}]"
        note = _note(spec)
        if value is None:
            yield f"{f'# {key} = derived':<34}# {note}"
        else:
            written = f"{key} = {_toml(value)}"
            yield f"{written:<34}# {note}" if note else written


def _note(spec: FieldSpec) -> str:
    if spec.kind == "text":
        return ""
    allowed = spec.range_text.replace('"', "")
    return f"{spec.unit}: {allowed}" if spec.unit else allowed


def _toml(value: object) -> str:
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    return repr(value)
