"""From a design to the finished report: compute, draw, typeset."""

from __future__ import annotations

import json
import platform
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from datetime import datetime
from importlib import metadata, resources
from pathlib import Path

from gearstudio import __version__
from gearstudio.catalogue import MemberName
from gearstudio.design import Design, all_field_specs
from gearstudio.design.choices import choice_title
from gearstudio.errors import Issue, ModellingError
from gearstudio.report.blocks import Pages
from gearstudio.report.chapters import chapter
from gearstudio.report.content import Beside, Content, gather
from gearstudio.report.fonts import FAMILIES, cjk_family
from gearstudio.report.language import CJK, MEMBERS_SAID, inline, language, moment, number, speaking, told, tr
from gearstudio.report.sections import SECTION_KEYS, SECTIONS
from gearstudio.report.store import Store, Taken
from gearstudio.words import ENGLISH, noted

Report = Callable[[str, float], None]
_COVER_WIDTH = 0.9
_TITLES = {section.key: section.title for section in SECTIONS}
_PARTS = ("cadquery-ocp-novtk", "numpy", "scipy", "typst")
_NO_FONT = noted(
    "no font with Chinese characters was found, so the report is in English; install one, such as Noto Sans CJK"
)


@dataclass(frozen=True)
class Order:
    """What a report is to have.

    Attributes
    ----------
    sections : tuple of str
        Keys of `SECTIONS`; they come in the order of the report.
    member : {"pinion", "wheel"}
        Whose flanks the maps show; tables have both.
    language : str
        A code of `LANGUAGES`.
    beside : Beside
        The project's folder, measured points.
    """

    sections: tuple[str, ...]
    member: MemberName
    language: str = ENGLISH
    beside: Beside = field(default_factory=Beside)


def compose(
    design: Design,
    order: Order,
    pictures: Callable[[], Taken],
    report: Report,
) -> Pages:
    """Compute and draw the report of a design.

    Parameters
    ----------
    design : Design
        Without errors.
    order : Order
        What goes in, in which language.
    pictures : callable
        Called last, for pictures of the three views (``views``) and of the pair (``pair``), when they are wanted.
    report : callable
        Takes the stage that begins and the fraction done.
    """
    warnings: tuple[str, ...] = ()
    code = order.language
    if code in CJK and cjk_family() is None:
        code, warnings = ENGLISH, (_NO_FONT,)
    with speaking(language(code)):
        pages = _composed(design, order, pictures, report)
        return replace(pages, language=code, words=_template_words(), warnings=warnings)


def _composed(design: Design, order: Order, pictures: Callable[[], Taken], report: Report) -> Pages:
    sections = order.sections
    content = gather(design, order.member, sections, report, order.beside)
    store, made = Store(), {}
    wanted = [key for key in SECTION_KEYS if key in sections and (key != "measurement" or order.beside.measured)]
    for index, key in enumerate(sorted(wanted, key=lambda one: one == "pictures")):
        if key == "pictures":
            report("waiting for pictures", 0.6 + 0.3 * index / len(wanted))
            store.taken = pictures()
        report(f"drawing {_TITLES[key]}", 0.6 + 0.3 * index / len(wanted))
        made[key] = chapter(key, content, store)
    cover = store.picture("pair", "", _COVER_WIDTH)
    chapters = tuple(made[key] for key in wanted)
    return Pages(design.name or tr("Unnamed pair"), _facts(content), chapters, store.files, cover)


def _template_words() -> dict[str, str]:
    """What the template says by itself."""
    return {"heading": tr("Spiral bevel gear report"), "printed": tr("The paper prints")}


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
        data = {**pages.data(), "fonts": FAMILIES}
        (root / "data.json").write_text(json.dumps(data), encoding="utf-8")
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
    made = tr(
        "{moment} by {program}, {kernel}",
        moment=moment(datetime.now().astimezone()), program=f"GearStudio {__version__}",
        kernel=f"Python {platform.python_version()}, {versions}, {platform.system()}",
    )  # fmt: skip
    return (
        (tr("Pair"), _pair_words(d)),
        (tr("Tooth form"), tr(
            "{curve}, spiral angle {spiral}° ({place}), pressure angle {pressure}° ({kind})",
            curve=tr(choice_title(d.lengthwise.curve)), spiral=number(d.lengthwise.spiral_angle_deg),
            place=inline(choice_title(d.lengthwise.spiral_angle_at)), pressure=number(d.pair.pressure_angle_deg),
            kind=inline(choice_title(d.pair.pressure_angle_kind)),
        )),
        (tr("Size"), tr(
            "outer cone distance {distance} mm, face width {width} mm (wheel)",
            distance=number(pair.wheel.outer_cone_distance, ".4f"), width=number(pair.wheel.face_width, ".4f"),
        )),
        (tr("Maps show"), tr(MEMBERS_SAID[content.member])),
        (tr("Tolerance"), tr("{size} µm for the optimised variants", size=number(d.methods.tolerance_um))),
        (tr("Made"), made),
        *((tr("Warning"), _issue(issue)) for issue in content.warnings),
        *((tr("Warning"), f"{told(doubt.message)}.") for doubt in _doubts(content)),
        *((tr("Note"), note) for note in content.notes),
    )  # fmt: skip


def _doubts(content: Content) -> tuple[Issue, ...]:
    """Why measured points may not be of this gear."""
    return content.measured.result.warnings if content.measured is not None else ()


def _issue(issue: Issue) -> str:
    """What is doubtful, and about which field."""
    spec = all_field_specs().get(issue.field)
    return told(issue.message) if spec is None else f"{tr(spec.title)}: {told(issue.message)}"


def _pair_words(d: Design) -> str:
    hand = tr("left-hand pinion") if d.pair.pinion_hand == "left" else tr("right-hand pinion")
    words = tr(
        "{pinion} / {wheel} teeth, outer module {module} mm, shaft angle {angle}°, {hand}",
        pinion=d.pair.pinion_teeth, wheel=d.pair.wheel_teeth, module=number(d.pair.outer_module),
        angle=number(d.pair.shaft_angle_deg), hand=hand,
    )  # fmt: skip
    return words + (tr(", offset {offset} mm", offset=number(d.pair.offset)) if d.pair.offset else "")
