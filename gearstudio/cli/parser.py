"""The command line's grammar."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Callable
from difflib import get_close_matches
from typing import Any, NoReturn

from gearstudio import __version__
from gearstudio.analysis.contact_placing import MARKING_THICKNESS_UM
from gearstudio.catalogue import MEMBERS, METHOD_IDS, VARIANTS
from gearstudio.cli import compare, contact, export, info, measure, points, report, screenshot, verify
from gearstudio.cli.numbers import echoed, number
from gearstudio.exchange.points import POINT_FORMATS
from gearstudio.formats import FORMATS
from gearstudio.theory.cloud import SPACINGS
from gearstudio.theory.flank import FLANKS

COMMANDS = ("info", "compare", "points", "export", "verify", "contact", "measure", "report", "screenshot")
FEWEST_LINES, MOST_LINES = 2, 2000


class Parser(argparse.ArgumentParser):
    """A parser that says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        """Print the problem and end with status 2."""
        print(f"{self.prog}: {message.replace(chr(10), ' ')}; see {self.prog} --help", file=sys.stderr)
        raise SystemExit(2)

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> tuple[Any, list[str]]:
        """As argparse, but four numbers after ``--misalign`` may begin with a minus."""
        words = list(sys.argv[1:] if args is None else args)
        for index in range(len(words) - 2, -1, -1):
            if words[index] == "--misalign" and re.match(r"-[\d.,]", words[index + 1]):
                words[index : index + 2] = [f"--misalign={words[index + 1]}"]
        return super().parse_known_args(words, namespace)


def nearest_command(word: str) -> str:
    """The command most like a mistyped word."""
    return get_close_matches(word, COMMANDS, 1, 0.0)[0]


def make_parser(take_picture: screenshot.TakePicture | None = None) -> argparse.ArgumentParser:
    """The grammar of every command; each sets ``run`` to the function that carries it out.

    ``take_picture`` carries out ``screenshot``, which belongs to the part that draws.
    """
    parser = Parser(
        prog="gearstudio",
        description="Spiral bevel gears from the exact spherical involute. Without a command, the window opens.",
        epilog="DESIGN is a design file (NAME.gear.toml) or a preset, as preset:default.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"GearStudio {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)

    def command(name: str, summary: str, run: Callable[[argparse.Namespace], int]) -> argparse.ArgumentParser:
        sub = commands.add_parser(name, help=summary, description=summary, allow_abbrev=False)
        sub.add_argument("design", metavar="DESIGN", help="a design file, or a preset as preset:default")
        sub.set_defaults(run=run)
        return sub

    made = command("info", "derived geometry of both members, and warnings", info.run)
    _add_json(made)

    made = command("compare", "build all methods and variants and print their deviations", compare.run)
    made.add_argument("--member", choices=(*MEMBERS, "both"), default="both", help="default: both")
    made.add_argument("--convergence", action="store_true", help="also how the deviation falls with the effort")
    _add_json(made)

    made = command("points", "write the theoretical point cloud of a flank", points.run)
    made.add_argument("--member", choices=MEMBERS, required=True)
    made.add_argument("--flank", choices=(*FLANKS, points.BOTH), required=True, help="both: as csv alone")
    made.add_argument("--rows", type=_lines, default=7, metavar="N", help="points from toe to heel; default: 7")
    made.add_argument("--cols", type=_lines, default=7, metavar="N", help="points from root to tip; default: 7")
    made.add_argument("--spacing", choices=SPACINGS, default="uniform", help="default: uniform")
    made.add_argument("--format", choices=POINT_FORMATS, required=True)
    made.add_argument("--out", required=True, metavar="FILE", help="- is standard output")

    made = command("export", "write a part as a method makes it", export.run)
    made.add_argument("--member", choices=(*MEMBERS, export.PAIR), required=True)
    made.add_argument("--part", choices=export.PARTS, required=True)
    made.add_argument("--method", choices=METHOD_IDS, default=METHOD_IDS[0], help=f"default: {METHOD_IDS[0]}")
    made.add_argument("--variant", choices=VARIANTS, default="optimised", help="default: optimised")
    made.add_argument(
        "--construction",
        choices=export.CONSTRUCTIONS,
        default="assemble",
        help="faces joined, or tooth spaces cut from the blank by Booleans (slow); default: assemble",
    )
    made.add_argument("--format", choices=FORMATS["gear"], action="append", required=True, help="may be repeated")
    made.add_argument("--out", required=True, metavar="DIR", help="made when missing")
    made.add_argument("--details", action="store_true", help="print what was found when each file was read back")
    made.add_argument("--record", action="store_true", help="keep that beside each file, for verify")
    export.add_options(made)

    summary = "hold exported files against their design again"
    made = commands.add_parser("verify", help=summary, description=summary, allow_abbrev=False)
    made.set_defaults(run=verify.run)
    made.add_argument("file", metavar="FILE", help="an exported file, its record, or a project (NAME.gear.toml)")
    made.add_argument("--design", metavar="DESIGN", help="of a file without a record")
    made.add_argument("--member", choices=(*MEMBERS, export.PAIR), help="default: as the file's name tells")
    made.add_argument("--part", choices=export.PARTS, help="default: as the file's name tells")
    made.add_argument("--method", choices=METHOD_IDS, default=METHOD_IDS[0], help=f"default: {METHOD_IDS[0]}")
    made.add_argument("--variant", choices=VARIANTS, default="optimised", help="default: optimised")
    made.add_argument("--folder", metavar="DIR", help="of a project's exports; default: the project's own")
    export.add_options(made)
    _add_json(made)

    made = command("contact", "tooth contact analysis for drive and coast", contact.run)
    made.add_argument(
        "--misalign", type=contact.misalignment, metavar="E,P,G,S", help="mm, mm, mm, degrees; default: 0,0,0,0"
    )
    made.add_argument(
        "--thickness", type=contact.thickness, default=MARKING_THICKNESS_UM, metavar="UM",
        help=f"of the marking compound in µm; default: {MARKING_THICKNESS_UM:g}",
    )  # fmt: skip
    made.add_argument(
        "--pinion", choices=contact.PINIONS, default=contact.PINIONS[0],
        help="with an offset: conjugate to the wheel (default), or on base cones of its own, as a reference",
    )  # fmt: skip
    _add_json(made)

    made = command("measure", "measured points against the theory", measure.run)
    made.add_argument(
        "points",
        metavar="POINTS",
        help="a file of points in mm (CSV, .dat, or columns with normals), or a STEP file of the gear from any program",
    )
    made.add_argument(
        "--spacing", type=_length, metavar="MM",
        help="how far apart points are taken from a STEP file; default: a twentieth of the face width",
    )  # fmt: skip
    made.add_argument("--member", choices=MEMBERS, required=True)
    made.add_argument("--no-turn", action="store_true", help="take the points as turned: no best fit about the axis")
    made.add_argument("--no-shift", action="store_true", help="take the points as placed: no best fit along the axis")
    _add_json(made)

    made = command("report", "the design, data sheets, comparison, maps, contact and equations as a PDF", report.run)
    report.add_arguments(made)

    made = command("screenshot", "take a picture of the views, without a window", take_picture or screenshot.refuse)
    screenshot.add_arguments(made)
    return parser


def _add_json(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--json", metavar="FILE", help="write the result as JSON too; - is standard output, then alone")


def _length(text: str) -> float:
    length = number(text)
    if not 0 < length < float("inf"):
        raise argparse.ArgumentTypeError(f"{echoed(text, 20)} is not a length in mm; use more than 0")
    return length


def _lines(text: str) -> int:
    try:
        count = int(text)
    except ValueError:
        count = 0
    if not FEWEST_LINES <= count <= MOST_LINES:
        raise argparse.ArgumentTypeError(
            f"{echoed(text, 20)} is not a number of lines; use {FEWEST_LINES} to {MOST_LINES}"
        )
    return count
