"""``screenshot``: the grammar of pictures without a window; they are painted by the part that draws the views."""

from __future__ import annotations

import argparse
from collections.abc import Callable

from gearstudio.catalogue import METHOD_IDS, VARIANTS
from gearstudio.errors import GearStudioError
from gearstudio.words import ENGLISH, LANGUAGES

MODES = ("flanks", "gear", "pair")
QUANTITIES = ("deviation", "gaussian", "mean", "largest", "smallest")
LEAST, MOST, MOST_SCALE = 64, 8192, 4
MOST_FACTOR = 10**8
TakePicture = Callable[[argparse.Namespace], int]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    add = parser.add_argument
    add("--out", required=True, metavar="FILE", help="a .png or .jpg file")
    add("--mode", choices=MODES, default="flanks", help="default: flanks")
    add("--member", choices=("pinion", "wheel"), default="wheel", help="default: wheel")
    add("--method", choices=("all", *METHOD_IDS), default="all", help="default: all, side by side")
    add("--variant", choices=VARIANTS, default="optimised", help="default: optimised")
    parser.add_argument(
        "--view", metavar="NAME", default=None, help="tooth, concave, convex, iso, front, top, fit, ..."
    )
    parser.add_argument(
        "--size", type=size, default=(1280, 720), metavar="WxH", help="of the layout; default: 1280x720"
    )
    parser.add_argument(
        "--scale", type=int, choices=range(1, MOST_SCALE + 1), default=1, help="pixels for one of these"
    )
    parser.add_argument(
        "--color", choices=QUANTITIES, default="deviation", help="what colours flanks; default: deviation"
    )
    parser.add_argument(
        "--exaggerate",
        type=factor,
        default=1,
        metavar="N",
        help="draw flanks with N times their deviation, or auto; default: 1",
    )
    add("--theme", choices=("light", "dark"), default="light", help="default: light")
    add("--parallel", action="store_true", help="without perspective")
    add("--transparent", action="store_true", help="clear where nothing is")
    add("--no-labels", action="store_true", help="without titles, axes and scales")
    add("--language", choices=LANGUAGES, default=ENGLISH, help="of the labels; default: en")


def factor(text: str) -> int:
    """A whole number from 1 on; 0 for ``auto``."""
    if text == "auto":
        return 0
    if not (text.isdecimal() and 1 <= int(text) <= MOST_FACTOR):
        raise argparse.ArgumentTypeError(f"{text[:20]} is no factor; use auto or a number from 1 to {MOST_FACTOR}")
    return int(text)


def size(text: str) -> tuple[int, int]:
    """``WxH`` in pixels."""
    width, _, height = text.lower().partition("x")
    if not (width.isdecimal() and height.isdecimal() and all(LEAST <= int(n) <= MOST for n in (width, height))):
        raise argparse.ArgumentTypeError(f"{text[:20]} is not a size; use WxH, as 1280x720, each {LEAST} to {MOST}")
    return int(width), int(height)


def refuse(args: argparse.Namespace) -> int:
    """What is said where nothing can draw."""
    raise GearStudioError("screenshot: the part that draws is not there; start it as `gearstudio screenshot`")
