"""``verify``: exported files held against their designs again."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from gearstudio.cli.export import chosen_options
from gearstudio.cli.findings import findings
from gearstudio.cli.output import STANDARD_OUTPUT, Progress, write_json
from gearstudio.errors import DesignError, FileError, Issue
from gearstudio.project import load_design, open_design

if TYPE_CHECKING:
    from gearstudio.exchange.verify import Verified

_PROJECT, _RECORD = ".toml", ".json"
_PARTS = ("flanks", "tooth", "gear")


def run(args: argparse.Namespace) -> int:
    """Carry the command out; 0 when every file is what it should be, 1 when not."""
    progress = Progress()
    try:
        found = _verified(args, progress)
    finally:
        progress.clear()
    if args.json != STANDARD_OUTPUT:
        print("\n".join(_text(one) for one in found))
    if args.json:
        write_json(args.json, {"good": _good(found), "files": [one.record() for one in found]})
    return 0 if _good(found) else 1


def _verified(args: argparse.Namespace, progress: Progress) -> Sequence[Verified]:
    from gearstudio.exchange.record import read_record, record_path
    from gearstudio.exchange.verify import verify_project, verify_record

    path = Path(args.file)
    if not path.is_file():
        raise FileError(path, "this is a folder, not a file" if path.is_dir() else "there is no such file")
    if path.suffix == _PROJECT:
        folder = Path(args.folder) if args.folder else path.parent
        found = verify_project(folder, load_design(path), progress)
        if not found:
            raise FileError(folder, "there are no exports here; export first, with --record to keep how they were made")
        return found
    if path.suffix == _RECORD:
        return [verify_record(read_record(path))]
    if args.design is None and record_path(path).is_file():
        return [verify_record(read_record(record_path(path)))]
    return [_against_design(path, args)]


def _against_design(path: Path, args: argparse.Namespace) -> Verified:
    from gearstudio.exchange.record import Subject
    from gearstudio.exchange.verify import format_of, verify_file

    format_ = format_of(path)
    first, _, second = path.stem.partition("-")
    member = args.member or (first if first in ("pinion", "wheel", "pair") else None)
    part = args.part or (second if second in _PARTS else "gear")
    missing = [name for name, value in (("--design", args.design), ("--member", member)) if value is None]
    if missing:
        text = "needed for a file that has no record beside it"
        raise DesignError([Issue("missing", name, text) for name in missing])
    subject = Subject(str(member), part, args.method, args.variant, "assemble", chosen_options(args))
    return verify_file(path, format_, open_design(args.design), subject)


def _good(found: Sequence[Verified]) -> bool:
    return all(not one.problems for one in found)


def _text(one: Verified) -> str:
    lines = [f"{one.path}: {'as it should be' if not one.problems else 'NOT as it should be'}"]
    lines += [f"  {problem}" for problem in one.problems]
    if one.check is not None:
        lines.append(findings(one.check))
    return "\n".join(lines)
