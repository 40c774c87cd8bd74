"""From a design to the finished report: compute, draw, typeset."""

from __future__ import annotations

import json
import platform
import tempfile
from collections.abc import Callable, Collection
from datetime import datetime
from importlib import metadata, resources
from pathlib import Path

from gearstudio import __version__
from gearstudio.catalogue import MemberName
from gearstudio.design import Design
from gearstudio.errors import ModellingError
from gearstudio.report.blocks import Pages
from gearstudio.report.chapters import chapter
from gearstudio.report.content import Content, gather
from gearstudio.report.sections import SECTION_KEYS
from gearstudio.report.store import Store, Taken

Report = Callable[[str, float], None]
_COVER_WIDTH = 0.9
_PARTS = ("cadquery-ocp-novtk", "numpy", "scipy", "typst")


def compose(
    design: Design,
    sections: Collection[str],
    member: MemberName,
    pictures: Callable[[], Taken],
    report: Report,
    folder: Path | None = None,
) -> Pages:
    """Compute and draw the report of a design.

    Parameters
    ----------
    design : Design
        Without errors.
    sections : collection of str
        Keys of `SECTIONS`; they come in the order of the report.
    member : {"pinion", "wheel"}
        Whose flanks the maps show; tables have both.
    pictures : callable
        Called last, for pictures of the three views (``views``) and of the pair (``pair``), when they are wanted.
    report : callable
        Takes the stage that begins and the fraction done.
    folder : Path, optional
        Where the project is, and with it the exports.
    """
    content = gather(design, member, sections, report, folder)
    store, made = Store(), {}
    wanted = [key for key in SECTION_KEYS if key in sections]
    for index, key in enumerate(sorted(wanted, key=lambda one: one == "pictures")):
        if key == "pictures":
            report("waiting for pictures", 0.6 + 0.3 * index / len(wanted))
            store.taken = pictures()
        report(f"drawing {key}", 0.6 + 0.3 * index / len(wanted))
        made[key] = chapter(key, content, store)
    cover = store.picture("pair", "", _COVER_WIDTH)
    chapters = tuple(made[key] for key in wanted)
    return Pages(design.name or "Unnamed pair", _facts(content), chapters, store.files, cover)


def typeset(pages: Pages, dots_per_inch: int = 0) -> tuple[bytes, ...]:
    """The pages as one PDF, or as a PNG picture each at a resolution.

    Raises
    ------
    ModellingError
        The typesetter refuses them.
    """
    import typst

    with tempfile.TemporaryDirectory(prefix="gearstudio-report-") as folder:
        root = Path(folder)
        template = resources.files("gearstudio.report") / "report.typ"
        (root / "report.typ").write_text(template.read_text(encoding="utf-8"), encoding="utf-8")
        (root / "data.json").write_text(json.dumps(pages.data()), encoding="utf-8")
        for name, content in pages.files.items():
            (root / name).write_bytes(content)
        try:
            if not dots_per_inch:
                return (bytes(typst.compile(root / "report.typ", root=root, format="pdf")),)
            made = typst.compile(root / "report.typ", root=root, format="png", ppi=dots_per_inch)
        except typst.TypstError as error:
            raise ModellingError("report", "typesetting", str(error)) from error
    return tuple(made) if isinstance(made, list) else (bytes(made),)


def _facts(content: Content) -> tuple[tuple[str, str], ...]:
    d, pair = content.design, content.pair
    versions = ", ".join(f"{name} {metadata.version(name)}" for name in _PARTS)
    facts = [
        ("Pair", f"{d.pair.pinion_teeth} / {d.pair.wheel_teeth} teeth, outer module {d.pair.outer_module:g} mm, "
                 f"shaft angle {d.pair.shaft_angle_deg:g}°, {d.pair.pinion_hand}-hand pinion"),
        ("Teeth", f"{d.lengthwise.curve.replace('_', ' ').capitalize()}, "
                  f"spiral angle {d.lengthwise.spiral_angle_deg:g}° at "
                  f"{d.lengthwise.spiral_angle_at}, pressure angle {d.pair.pressure_angle_deg:g}° "
                  f"{d.pair.pressure_angle_kind}"),
        ("Size", f"outer cone distance {pair.wheel.outer_cone_distance:.4f} mm, "
                 f"face width {pair.wheel.face_width:.4f} mm"),
        ("Maps show", f"the {content.member}"),
        ("Tolerance", f"{d.methods.tolerance_um:g} µm for the optimised variants"),
        ("Made", f"{datetime.now().astimezone():%Y-%m-%d %H:%M %Z} by GearStudio {__version__}"),
        ("With", f"Python {platform.python_version()}, {versions}, on {platform.system()}"),
        *(("Note", note) for note in content.notes),
    ]  # fmt: skip
    return tuple(facts)
