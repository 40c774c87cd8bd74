"""What was exported beside the project: the records that every export leaves, as a chapter."""

from __future__ import annotations

import json
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from gearstudio.catalogue import METHOD_INFOS
from gearstudio.checks import FaceCheck
from gearstudio.design import Design
from gearstudio.errors import FileError
from gearstudio.exchange.record import SUFFIX, ExportRecord, checksum, read_record
from gearstudio.exchange.verify import different_fields
from gearstudio.files import read_bytes
from gearstudio.report.blocks import Block, Table, Text, rows
from gearstudio.report.language import MEMBERS_SAID, inline, moment, number, told, tr
from gearstudio.words import noted

_MOST = 60
_MOST_FIELDS = 4
_LEAST_UM = 1e-4
_PARTS = {"gear": noted("whole gear"), "tooth": noted("one tooth"), "flanks": noted("both flanks")}


@dataclass(frozen=True)
class Exported:
    """A file that was exported.

    Attributes
    ----------
    name, what, made, found : str
        The file's name; what is in it; when and with what; what the kernel found on reading it back.
    faces : tuple of FaceCheck
        Of each kind of face the one farthest from theory.
    remarks : tuple of str
        What does not hold any more; empty when all is as it was written.
    """

    name: str
    what: str
    made: str
    found: str
    faces: tuple[FaceCheck, ...]
    remarks: tuple[str, ...]


def exports_in(folder: Path | None, design: Design) -> tuple[Exported, ...]:
    """The exports that have a record in a folder, by name."""
    if folder is None:
        return ()
    return tuple(_exported(path, design) for path in sorted(folder.glob(f"*{SUFFIX}"))[:_MOST])


def chapter_blocks(found: tuple[Exported, ...], folder: Path | None) -> list[Block]:
    """The chapter: of each file what it is, whether it still is so, and its faces."""
    if folder is None:
        return [Text(tr("The design is not saved, so there is no folder in which exports could be."))]
    if not found:
        return [Text(tr("There are no exports with a record in {folder}.", folder=folder))]
    made: list[tuple[str, ...]] = []
    remarks: list[Block] = []
    for one in found:
        made.append((f"{one.name}: {one.what}",))
        made += [
            (f"{tr(MEMBERS_SAID[face.member])}, {_face(face)}", _small(face.largest_um), number(face.limit_um, ".3g"),
             tr("within") if face.good else tr("OUT OF LIMITS"))
            for face in one.faces
        ]  # fmt: skip
        remarks += [Text(f"{one.name}: {remark}.") for remark in one.remarks]
    files = [(one.name, one.found, one.made) for one in found]
    summary = Table((tr("File"), tr("Read back"), tr("Written")), rows(files), "kll", (0.0, 1.0, 1.0))
    head = (tr("Face farthest from theory"), tr("Largest [µm]"), tr("Limit [µm]"), tr("Verdict"))
    intro = tr("Every file was read back after it was written, and held against the exact geometry.")
    return [Text(intro), summary, *remarks, Table(head, rows(made), "lddl")]


def _exported(path: Path, design: Design) -> Exported:
    try:
        record = read_record(path)
        data = json.loads(read_bytes(path))
        check = data["check"]
        faces = tuple(FaceCheck(**face) for face in check["deviations"])
        words = _words(check)
        made = tr(
            "{moment} by {program}, {kernel}",
            moment=moment(datetime.fromisoformat(data["written"])).strip(),
            program=data["program"], kernel=check["kernel"],
        )  # fmt: skip
    except FileError as error:
        return Exported(path.name, "", "", "", (), (told(error.reason),))
    except (KeyError, TypeError, ValueError):
        return Exported(path.name, "", "", "", (), (tr("the record does not say what was found"),))
    remarks = (*(told(problem) for problem in check.get("problems", ())), *_changes(record, design))
    return Exported(record.path.name, _what(record), made, words, worst(faces), remarks)


def worst(faces: tuple[FaceCheck, ...]) -> tuple[FaceCheck, ...]:
    """Of each kind of face of each member the one farthest from theory."""
    found: dict[tuple[str, str], FaceCheck] = {}
    for face in faces:
        key = face.member, face.name
        if key not in found or face.largest_um > found[key].largest_um:
            found[key] = face
    return tuple(found.values())


def _what(record: ExportRecord) -> str:
    subject = record.subject
    part = tr(_PARTS.get(subject.part, subject.part))
    method = next((inline(info.title) for info in METHOD_INFOS if info.id == subject.method), subject.method)
    return ", ".join((tr(subject.member), part, method, tr(subject.variant)))


def _face(face: FaceCheck) -> str:
    name = told(face.name)
    return tr("{face}, tooth {number}", face=name, number=face.tooth) if face.tooth else name


def _small(value_um: float) -> str:
    return number(value_um, ".4g") if value_um >= _LEAST_UM else f"< {number(_LEAST_UM, 'g')}"


def _words(check: dict[str, object]) -> str:
    found = [
        tr("solids: {count}", count=check["solids"]), tr("faces: {count}", count=check["faces"]),
        tr("valid") if check["valid"] else tr("NOT VALID"), tr("closed") if check["closed"] else "",
    ]  # fmt: skip
    return ", ".join(filter(None, found))


def _changes(record: ExportRecord, design: Design) -> list[str]:
    made = []
    if not record.path.is_file():
        made.append(tr("the file is gone; its record is still there"))
    elif checksum(record.path) != record.checksum:
        made.append(tr("the file is not as it was written: its checksum is another"))
    fields = different_fields(record.design, design)
    if fields:
        changed = ", ".join(fields[:_MOST_FIELDS])
        if len(fields) > _MOST_FIELDS:
            changed = tr("{fields} and {count} more", fields=changed, count=len(fields) - _MOST_FIELDS)
        made.append(tr("it was made of another state of the design; changed since: {fields}", fields=changed))
    return made
