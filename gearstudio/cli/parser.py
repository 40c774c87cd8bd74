"""The command line's grammar."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from difflib import get_close_matches
from typing import NoReturn

from gearstudio import __version__
from gearstudio.catalogue import MEMBERS, METHOD_IDS, VARIANTS
from gearstudio.cli import compare, export, info, points
from gearstudio.exchange.points import POINT_FORMATS
from gearstudio.theory.cloud import SPACINGS
from gearstudio.theory.flank import FLANKS

COMMANDS = ("info", "compare", "points", "export")
FEWEST_LINES, MOST_LINES = 2, 2000
EXPORT_FORMATS = ("step", "iges", "brep", "stl", "3mf", "glb")


class Parser(argparse.ArgumentParser):
    """A parser that says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        """Print the problem and end with status 2."""
        print(f"{self.prog}: {message.replace(chr(10), ' ')}; see {self.prog} --help", file=sys.stderr)
        raise SystemExit(2)


def nearest_command(word: str) -> str:
    """The command most like a mistyped word."""
    return get_close_matches(word, COMMANDS, 1, 0.0)[0]


def make_parser() -> argparse.ArgumentParser:
    """The grammar of every command; each sets ``run`` to the function that carries it out."""
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
    _add_json(made)

    made = command("points", "write the theoretical point cloud of a flank", points.run)
    made.add_argument("--member", choices=MEMBERS, required=True)
    made.add_argument("--flank", choices=FLANKS, required=True)
    made.add_argument("--rows", type=_lines, default=7, metavar="N", help="points from toe to heel; default: 7")
    made.add_argument("--cols", type=_lines, default=7, metavar="N", help="points from root to tip; default: 7")
    made.add_argument("--spacing", choices=SPACINGS, default="uniform", help="default: uniform")
    made.add_argument("--format", choices=POINT_FORMATS, required=True)
    made.add_argument("--out", required=True, metavar="FILE", help="- is standard output")

    made = command("export", "write a part as a method makes it", export.run)
    made.add_argument("--member", choices=(*MEMBERS, *export.MEMBERS_TO_COME), required=True)
    made.add_argument("--part", choices=(*export.PARTS, *export.PARTS_TO_COME), required=True)
    made.add_argument("--method", choices=METHOD_IDS, default=METHOD_IDS[0], help=f"default: {METHOD_IDS[0]}")
    made.add_argument("--variant", choices=VARIANTS, default="optimised", help="default: optimised")
    made.add_argument("--format", choices=EXPORT_FORMATS, action="append", required=True, help="may be repeated")
    made.add_argument("--out", required=True, metavar="DIR", help="made when missing")
    return parser


def _add_json(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--json", metavar="FILE", help="write the result as JSON too; - is standard output, then alone")


def _lines(text: str) -> int:
    try:
        count = int(text)
    except ValueError:
        count = 0
    if not FEWEST_LINES <= count <= MOST_LINES:
        shown = text if len(text) <= 20 else f"{text[:19]}…"
        raise argparse.ArgumentTypeError(f"{shown} is not a number of lines; use {FEWEST_LINES} to {MOST_LINES}")
    return count
