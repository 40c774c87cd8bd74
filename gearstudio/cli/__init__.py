"""The command line: everything that works without a window."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Sequence

from gearstudio.cli.output import problem
from gearstudio.cli.parser import COMMANDS, make_parser, nearest_command
from gearstudio.cli.screenshot import TakePicture
from gearstudio.errors import DesignError, FileError, GearStudioError
from gearstudio.files import log_failure

__all__ = ["COMMANDS", "main", "nearest_command"]

DONE, OUR_FAILURE, UNUSABLE_INPUT, INTERRUPTED = 0, 1, 2, 130


def main(argv: Sequence[str], take_picture: TakePicture | None = None) -> int:
    """Carry out one command.

    Parameters
    ----------
    argv : sequence of str
        The command and its arguments, without the program's name.
    take_picture : callable, optional
        Carries out ``screenshot``; who may import the part that draws hands it in.

    Returns
    -------
    int
        Exit status: 0; 2 for unusable input; 1 for a failure of ours; 130 when interrupted. Each problem is
        one line on standard error.
    """
    _never_fail_at_printing()
    try:
        args = make_parser(take_picture).parse_args(argv)
        status = int(args.run(args))
        sys.stdout.flush()
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else DONE
    except DesignError as error:
        for issue in error.issues:
            problem(f"{error.path}: {issue}" if error.path and not issue.field else str(issue))
        return UNUSABLE_INPUT
    except FileError as error:
        problem(str(error))
        return UNUSABLE_INPUT
    except GearStudioError as error:
        problem(str(error))
        return OUR_FAILURE
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE
    except KeyboardInterrupt:
        problem("interrupted")
        return INTERRUPTED
    except Exception as error:
        problem(f"unexpected failure: {type(error).__name__}: {error}; details are in {log_failure(error)}")
        return OUR_FAILURE
    return status


def _never_fail_at_printing() -> None:
    """Letters that the terminal cannot show become question marks."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
