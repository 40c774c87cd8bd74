"""The one door: a command word works without a window, anything else opens it."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import MutableMapping, Sequence
from pathlib import Path

COMMANDS = ("info", "compare", "points", "export", "verify", "contact", "measure", "report", "screenshot")


def main(argv: Sequence[str] | None = None) -> int:
    """Run GearStudio with the arguments after the program's name; the exit status."""
    try:
        return _run(list(sys.argv[1:] if argv is None else argv))
    except KeyboardInterrupt:
        return 130
    except ImportError as error:
        print(f"GearStudio is not completely installed: {error}", file=sys.stderr)
        return 1


def _run(arguments: list[str]) -> int:
    first = arguments[0] if arguments else ""
    if first in COMMANDS or first in ("-h", "--help", "--version"):
        from gearstudio.cli import main as command_line

        return command_line(arguments, _take_picture)
    if _looks_like_a_command(first):
        return _refuse(first)
    from ui.app import main as window
    from ui.leaving import leave

    leave(window(arguments))


def _take_picture(args: Namespace) -> int:
    from ui.views.command import take_picture

    return take_picture(args)


def give_back_search_path(environment: MutableMapping[str, str]) -> None:
    """Other programs, as the browser that a link opens, are not to load the libraries of the bundle."""
    before = environment.pop("LD_LIBRARY_PATH_ORIG", None)
    environment.pop("LD_LIBRARY_PATH", None)
    if before is not None:
        environment["LD_LIBRARY_PATH"] = before
    environment["PYINSTALLER_RESET_ENVIRONMENT"] = "1"  # the bundle, started again, sets its path again


def _looks_like_a_command(word: str) -> bool:
    return word.replace("-", "").isalpha() and not word.startswith("-") and not Path(word).exists()


def _refuse(word: str) -> int:
    from gearstudio.cli import nearest_command

    reason = f"{word}: no such command or design file; the nearest command is {nearest_command(word)}"
    print(f"{reason}; commands: {', '.join(COMMANDS)}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    if getattr(sys, "frozen", False):
        import multiprocessing

        multiprocessing.freeze_support()  # the CAD process of a bundle is this program again
        give_back_search_path(os.environ)
    sys.exit(main())
