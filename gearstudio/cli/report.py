"""``report``: the design, its data sheets, the comparison, maps, contact and equations as a PDF."""

from __future__ import annotations

import argparse
from pathlib import Path

from gearstudio.cli.output import Progress
from gearstudio.files import write_bytes
from gearstudio.project import open_design
from gearstudio.report.job import ReportJob
from gearstudio.report.sections import SECTION_KEYS


def run(args: argparse.Namespace) -> int:
    """Carry the command out."""
    design = open_design(args.design)
    progress = Progress()
    pictures = args.take_pictures(args.design, args.member) if "pictures" in args.sections else {}
    try:
        made = ReportJob(design, args.sections, args.member, tuple(pictures.items())).run(progress)
    finally:
        progress.clear()
    write_bytes(Path(args.out), made.pdf)
    print(args.out)
    return 0


def sections(text: str) -> tuple[str, ...]:
    """Keys of sections, separated by commas.

    Raises
    ------
    argparse.ArgumentTypeError
        There is no such section.
    """
    keys = tuple(part.strip() for part in text.split(","))
    for key in keys:
        if key not in SECTION_KEYS:
            raise argparse.ArgumentTypeError(f"{key!r} is no section; use some of {', '.join(SECTION_KEYS)}")
    return keys
