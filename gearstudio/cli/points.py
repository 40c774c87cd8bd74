"""``points``: the theoretical points of a flank as a file, or of both with normals for a measuring machine."""

from __future__ import annotations

import argparse

from gearstudio.cli.output import problem, write_output
from gearstudio.exchange.measured import nominal_grid_text
from gearstudio.exchange.points import point_cloud, points_text
from gearstudio.project import open_design
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.modified import flank_of

BOTH = "both"
UNUSABLE_INPUT = 2


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status is 2 when both flanks are asked for in a format that cannot tell them."""
    member = pair_geometry(open_design(args.design)).member(args.member)
    if args.flank != BOTH:
        cloud = point_cloud(flank_of(member, args.flank), args.rows, args.cols, args.spacing)
        text = points_text(cloud, args.format)
    elif args.format == "csv":
        text = nominal_grid_text(member, args.rows, args.cols, args.spacing)
    else:
        problem(f"--flank both: {args.format} does not tell the flanks apart; use --format csv, or one flank at a time")
        return UNUSABLE_INPUT
    write_output(args.out, text)
    return 0
