"""``report``: the design, its data sheets, the comparison, maps, contact and equations as a PDF."""

from __future__ import annotations

import argparse
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from gearstudio.catalogue import MEMBERS
from gearstudio.cli.output import Progress, problem
from gearstudio.cli.report_pictures import Photographers, photographers
from gearstudio.files import write_bytes
from gearstudio.project import open_design
from gearstudio.report.sections import SECTION_KEYS

if TYPE_CHECKING:
    from gearstudio.report.store import Taken


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("--out", required=True, metavar="FILE", help="a .pdf file")
    parser.add_argument("--member", choices=MEMBERS, default="wheel", help="whose maps are drawn; default: wheel")
    parser.add_argument(
        "--sections", type=sections, default=SECTION_KEYS, metavar="A,B,…",
        help=f"some of {', '.join(SECTION_KEYS)}; default: all",
    )  # fmt: skip


def run(args: argparse.Namespace) -> int:
    """Carry the command out."""
    design, project = open_design(args.design), Path(args.design)
    from gearstudio.report.document import compose, typeset

    progress = Progress()
    folder = project.resolve().parent if project.is_file() else None
    wanted = "pictures" in args.sections
    try:
        with photographers(args.design, args.member) if wanted else nullcontext() as at_work:
            pages = compose(design, args.sections, args.member, lambda: _taken(at_work), progress, folder)
        progress("setting the pages", 0.9)
        write_bytes(Path(args.out), typeset(pages)[0])
    finally:
        progress.clear()
    print(args.out)
    return 0


def _taken(at_work: Photographers | None) -> Taken:
    from gearstudio.report.store import Taken

    taken = Taken() if at_work is None else at_work.taken()
    for said in taken.problems:
        problem(f"a picture is missing in the report: {said}")
    return taken


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
            raise argparse.ArgumentTypeError(f"{key[:20]!r} is no section; use some of {', '.join(SECTION_KEYS)}")
    return keys
