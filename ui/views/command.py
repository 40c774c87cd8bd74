"""The command ``screenshot``: the views of a design as a picture, without a window and without a screen."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from gearstudio.catalogue import METHOD_IDS
from gearstudio.cli.output import Progress, problem
from gearstudio.errors import FileError

if TYPE_CHECKING:
    from gearstudio.design import Design
    from ui.color_bar import ColorBar
    from ui.view_grid import ViewGrid

SUFFIXES = (".png", ".jpg", ".jpeg")
OUR_FAILURE, UNUSABLE_INPUT = 1, 2


def take_picture(args: argparse.Namespace) -> int:
    """Carry the command out."""
    from gearstudio.project import open_design

    path = Path(args.out)
    if path.suffix.lower() not in SUFFIXES:
        raise FileError(path, f"a picture needs a name that ends in {', '.join(SUFFIXES[:2])}")
    design = open_design(args.design)
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    from PySide6.QtCore import Qt

    from ui.app import make_application
    from ui.camera import VIEWS
    from ui.language import install
    from ui.theme import Theme

    if args.view is not None and args.view not in VIEWS:
        problem(f"--view {args.view[:40]}: no such view; there are {', '.join(VIEWS)}")
        return UNUSABLE_INPUT
    application = make_application([sys.argv[0]])
    install(application, args.language)
    Theme(application).choose(Qt.ColorScheme.Dark if args.theme == "dark" else Qt.ColorScheme.Light)
    progress = Progress()
    try:
        grid, bar = _views(design, args, progress)
        status = _save(grid, bar, args, path, progress)
    finally:
        progress.clear()
    if status == 0:
        print(path)
    return status


def has_scale(args: argparse.Namespace) -> bool:
    """Whether the picture has a colour scale; the pair is drawn plainly."""
    return not args.no_labels and args.mode != "pair"


def _views(design: Design, args: argparse.Namespace, progress: Progress) -> tuple[ViewGrid, ColorBar]:
    from PySide6.QtCore import QSize

    from ui.color_bar import ColorBar
    from ui.view_grid import ViewGrid
    from ui.views.appearance import Appearance
    from ui.views.pictures import lay_out
    from ui.views.quantities import quantity_of
    from ui.views.still import StillViewport

    grid, bar = ViewGrid(make_viewport=StillViewport), ColorBar()
    appearance = Appearance(quantity=args.color, parallel=args.parallel, exaggeration=args.exaggerate)
    beside = bar.sizeHint().width() if has_scale(args) else 0
    lay_out(grid, QSize(args.size[0] - beside, args.size[1]))
    grid.set_theme(args.theme == "dark")
    grid.show_appearance(appearance)
    bar.show_scale(quantity_of(appearance), appearance.colors, appearance.steps, appearance.unit)
    bar.range_changed.connect(lambda low, high: grid.set_color_range(high, low))
    if args.mode == "flanks":
        _show_flanks(design, args, progress, grid, bar)
    else:
        _show_solids(design, args, progress, grid, bar)
    grid.set_view(args.view or {"flanks": "tooth", "gear": "iso", "pair": "pair"}[args.mode])
    return grid, bar


def _show_flanks(design: Design, args: argparse.Namespace, progress: Progress, grid: ViewGrid, bar: ColorBar) -> None:
    from gearstudio.jobs import BuildJob
    from gearstudio.theory.cones import pair_geometry
    from ui.layers import Panel
    from ui.presenter import exaggerated_words, largest_of, result_words, view_title
    from ui.scene import member_layers, result_layers
    from ui.session import Key
    from ui.views.dressing import dressed
    from ui.views.exaggeration import displaced, factor_for
    from ui.views.quality import variant_quality
    from ui.views.quantities import quantity_of, typical_range
    from ui.words import tr

    member, quantity = pair_geometry(design).member(args.member), quantity_of(grid.appearance)
    keys = [Key(args.member, m, args.variant) for m in (METHOD_IDS if args.method == "all" else (args.method,))]
    results = [BuildJob(design, args.member, key.method, args.variant).run(progress) for key in keys]
    factor = factor_for(args.exaggerate, results)
    panels = []
    for key, result in zip(keys, results, strict=True):
        quality = None if quantity.is_deviation else variant_quality(result, member)
        bent = displaced(result_layers(result), result, member, factor)
        layers = dressed(bent, result, quality, grid.appearance, 1.0)
        below = exaggerated_words(result_words(result) if quantity.is_deviation else tr(quantity.title), factor)
        panels.append(Panel(key.method, view_title(key), below, (*member_layers(member), *layers)))
    bar.show_exaggeration(factor)
    if quantity.is_deviation:
        bar.set_data_limit(largest_of(results))
    else:
        values = [x.scalars for panel in panels for x in panel.layers if x.scalars is not None]
        found = typical_range(quantity, values)
        if found is not None:
            bar.set_data_range(*found)
    grid.set_panels(panels)
    grid.set_color_range(bar.range[1], bar.range[0])


def _show_solids(design: Design, args: argparse.Namespace, progress: Progress, grid: ViewGrid, bar: ColorBar) -> None:
    from gearstudio.jobs import GearJob
    from gearstudio.theory.cones import pair_geometry
    from ui.presenter import view_title
    from ui.session import Key
    from ui.solid_layers import SolidOptions
    from ui.solid_view import PAIR, SolidView
    from ui.solids import meshed

    method = METHOD_IDS[0] if args.method == "all" else args.method
    keys = [Key(member, method, args.variant) for member in (PAIR if args.mode == "pair" else (args.member,))]
    built = {key: meshed(design, GearJob(design, key.member, method, args.variant).run(progress)) for key in keys}
    view = SolidView(grid)
    options = SolidOptions(deviation=has_scale(args))
    bar.set_data_limit(max(one.largest_um for one in built.values()))
    view.show(pair_geometry(design), keys, built, options, (view_title(keys[0]), design.name))
    grid.set_color_range(bar.range[1], bar.range[0])


def _save(grid: ViewGrid, bar: ColorBar, args: argparse.Namespace, path: Path, progress: Progress) -> int:
    from ui.views.picture_files import write_picture
    from ui.views.pictures import PictureOptions, at_once, painted

    shown = has_scale(args)
    options = PictureOptions(args.scale, args.transparent, not args.no_labels, shown)
    try:
        picture = at_once(painted(grid, bar if shown else None, options), lambda done: progress("drawing", done))
    except RuntimeError as error:
        problem(f"{error}; install a software OpenGL (Mesa), or run on a screen")
        return OUR_FAILURE
    write_picture(path, picture)
    return 0
