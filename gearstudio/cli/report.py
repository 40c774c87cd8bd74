"""``report``: the design, its data sheets, the comparison, maps, contact and equations as a PDF."""

from __future__ import annotations

import argparse
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from gearstudio.catalogue import MEMBERS
from gearstudio.cli.output import Progress, problem
from gearstudio.cli.report_pictures import Photographers, photographers
from gearstudio.errors import GeometryError
from gearstudio.files import write_bytes
from gearstudio.project import open_design
from gearstudio.report.sections import SECTION_KEYS
from gearstudio.theory.cones import pair_geometry
from gearstudio.words import ENGLISH, LANGUAGES

if TYPE_CHECKING:
    from gearstudio.design import Design
    from gearstudio.report.measuring import Measured
    from gearstudio.report.store import Taken

UNUSABLE_INPUT = 2


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("--out", required=True, metavar="FILE", help="a .pdf file")
    parser.add_argument("--member", choices=MEMBERS, default="wheel", help="whose maps are drawn; default: wheel")
    parser.add_argument(
        "--sections", type=sections, default=SECTION_KEYS, metavar="A,B,…",
        help=f"some of {', '.join(SECTION_KEYS)}; default: all",
    )  # fmt: skip
    parser.add_argument("--language", choices=LANGUAGES, default=ENGLISH, help="of the report; default: en")
    parser.add_argument(
        "--measured", metavar="FILE",
        help="measured points of the member in mm, or a STEP file of it, for the section about them",
    )  # fmt: skip


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status is 2 when the measured points are missing or not of this gear."""
    if args.measured is None and args.sections == ("measurement",):
        problem("the section measurement needs measured points; add --measured FILE")
        return UNUSABLE_INPUT
    design, project = open_design(args.design), Path(args.design)
    from gearstudio.report.content import Beside
    from gearstudio.report.document import Order, compose, typeset

    progress = Progress()
    folder = project.resolve().parent if project.is_file() else None
    wanted = "pictures" in args.sections
    try:
        measured = _measured(args, design, progress)
        order = Order(args.sections, args.member, args.language, Beside(folder, measured))
        taking = photographers(args.design, args.member, args.language) if wanted else nullcontext()
        with taking as at_work:
            pages = compose(design, order, lambda: _taken(at_work), progress)
        progress("setting the pages", 0.9)
        write_bytes(Path(args.out), typeset(pages)[0])
    except GeometryError as error:
        problem(f"{args.measured}: {error}")
        return UNUSABLE_INPUT
    finally:
        progress.clear()
    for warning in pages.warnings:
        problem(warning)
    for doubt in measured.result.warnings if measured is not None else ():
        problem(f"{args.measured}: warning: {doubt}")
    print(args.out)
    return 0


def _measured(args: argparse.Namespace, design: Design, progress: Progress) -> Measured | None:
    """The measured points against the design: whoever asks for them is told at once when they are of another gear."""
    if args.measured is None:
        return None
    from gearstudio.report.measuring import compared, read_file

    pair = pair_geometry(design)
    file = read_file(Path(args.measured), pair, args.member, lambda stage, _part: progress(stage, 0.0))
    return compared(design, pair, file)


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
