"""``points``: the theoretical point cloud of a flank as a file."""

from __future__ import annotations

import argparse

from gearstudio.cli.output import write_output
from gearstudio.exchange.points import point_cloud, points_text
from gearstudio.project import open_design
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.modified import flank_of


def run(args: argparse.Namespace) -> int:
    """Carry the command out; the exit status."""
    member = pair_geometry(open_design(args.design)).member(args.member)
    cloud = point_cloud(flank_of(member, args.flank), args.rows, args.cols, args.spacing)
    write_output(args.out, points_text(cloud, args.format))
    return 0
