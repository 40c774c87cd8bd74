"""``export``: a part of a member as a method makes it, for other CAD programs."""

from __future__ import annotations

import argparse
from pathlib import Path

from gearstudio.cli.output import Progress
from gearstudio.errors import DesignError, Issue
from gearstudio.project import open_design

PARTS = ("flanks",)
PARTS_TO_COME = ("tooth", "gear")
MEMBERS_TO_COME = ("pair",)


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status."""
    from gearstudio.jobs import ExportJob

    _refuse_what_is_to_come(args)
    design = open_design(args.design)
    formats = tuple(dict.fromkeys(args.format))
    job = ExportJob(design, args.member, args.part, args.method, args.variant, formats, Path(args.out))
    progress = Progress()
    try:
        files = job.run(progress)
    finally:
        progress.clear()
    for file in files:
        print(file.path)
    return 0


def _refuse_what_is_to_come(args: argparse.Namespace) -> None:
    from gearstudio.jobs import FLANK_FORMATS

    issues = []
    if args.part in PARTS_TO_COME:
        issues.append(Issue("not_available", "--part", f"{args.part} is not available yet; use {' or '.join(PARTS)}"))
    if args.member in MEMBERS_TO_COME:
        issues.append(Issue("not_available", "--member", f"{args.member} is not available yet; use pinion or wheel"))
    issues += [
        Issue("not_available", "--format", f"{name} is not available yet; use {' or '.join(FLANK_FORMATS)}")
        for name in dict.fromkeys(args.format)
        if name not in FLANK_FORMATS
    ]
    if issues:
        raise DesignError(issues)
