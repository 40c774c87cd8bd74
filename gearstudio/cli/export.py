"""``export``: flanks, a tooth, a gear or the pair as a method makes them, for other programs."""

from __future__ import annotations

import argparse
from pathlib import Path

from gearstudio.cli.output import Progress
from gearstudio.errors import DesignError, Issue
from gearstudio.jobs import CONSTRUCTIONS, FORMATS
from gearstudio.project import open_design

PARTS = tuple(FORMATS)
PAIR = "pair"
__all__ = ["CONSTRUCTIONS", "PAIR", "PARTS", "run"]


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status."""
    from gearstudio.jobs import ExportJob

    _refuse_what_does_not_go_together(args)
    design = open_design(args.design)
    formats = tuple(dict.fromkeys(args.format))
    job = ExportJob(
        design,
        args.member,
        args.part,
        args.method,
        args.variant,
        formats,
        Path(args.out),
        args.construction,
        args.chord,
    )
    progress = Progress()
    try:
        files = job.run(progress)
    finally:
        progress.clear()
    for file in files:
        print(file.path)
    return 0


def _refuse_what_does_not_go_together(args: argparse.Namespace) -> None:
    offered = FORMATS[args.part]
    issues = [
        Issue("not_offered", "--format", f"{args.part} cannot be written as {name}; use {' or '.join(offered)}")
        for name in dict.fromkeys(args.format)
        if name not in offered
    ]
    if args.member == PAIR and args.part != "gear":
        issues.append(Issue("not_offered", "--part", f"{args.part} is of one member; a pair is written as gear"))
    if issues:
        raise DesignError(issues)
