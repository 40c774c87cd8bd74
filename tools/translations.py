"""Keeps the translation files: `python tools/translations.py update | release | missing | fill FILE...`.

``update`` collects the texts of the source into ``ui/translations/*.ts`` (translations are kept, texts that are gone
are dropped) and the templates of the core's sentences into ``sentences.json``; ``release`` makes the ``.qm`` files that
the window loads and the catalogues of the report; ``missing`` lists what lacks a translation, as JSON; ``fill`` puts
translations in, from JSON files such as ``{"de": {"English": "Deutsch"}}``.

Words that Qt's own translations lack are in ``qt_zh.ts``, which is kept by hand.

A text that ``gearstudio/report`` says with ``tr`` is collected like one of the window: the .ts files are the one place
for translations. The core knows no Qt, so `release` copies what the report may say from them.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tools.collecting import core_sentences, report_tables, report_words, table_words, window_words  # noqa: E402

FOLDER = ROOT / "ui" / "translations"
CATALOGUES = ROOT / "gearstudio" / "report" / "words"
LANGUAGES = {"de": "de_DE", "zh": "zh_CN"}
WORDS, SENTENCES = "GearStudio", "Sentences"
Texts = dict[str, dict[str, str]]
"""Translations (empty where there is none) by English text, by context."""


def collected() -> dict[str, list[str]]:
    """The texts of the source by context, sorted."""
    return {WORDS: sorted(window_words() | report_words() | table_words()), SENTENCES: sorted(core_sentences())}


def ts_path(language: str) -> Path:
    """The translation file of a language."""
    return FOLDER / f"gearstudio_{language}.ts"


def read_ts(path: Path) -> Texts:
    """The translations of a file; none where there is no file yet."""
    found: Texts = {WORDS: {}, SENTENCES: {}}
    if path.exists():
        for context in ET.parse(path).getroot().iter("context"):
            texts = found[context.findtext("name", WORDS)]
            for message in context.iter("message"):
                texts[message.findtext("source", "")] = message.findtext("translation", "") or ""
    return found


def write_ts(path: Path, code: str, texts: Mapping[str, Mapping[str, str]]) -> None:
    """Write a translation file."""
    root = ET.Element("TS", version="2.1", language=code, sourcelanguage="en")
    for name, said in texts.items():
        context = ET.SubElement(root, "context")
        ET.SubElement(context, "name").text = name
        for source, translation in said.items():
            message = ET.SubElement(context, "message")
            ET.SubElement(message, "source").text = source
            element = ET.SubElement(message, "translation")
            element.text = translation
            if not translation:
                element.set("type", "unfinished")
    ET.indent(root, " ")
    body = ET.tostring(root, encoding="unicode")
    path.write_text(f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{body}\n', encoding="utf-8")


def merged(texts: Mapping[str, Sequence[str]], known: Texts) -> Texts:
    """The texts of the source with the translations that are known, from either context."""
    every = {**known[SENTENCES], **known[WORDS]}
    return {name: {text: known[name].get(text) or every.get(text, "") for text in said} for name, said in texts.items()}


def update() -> None:
    """Bring the .ts files and the list of sentences up to date with the source."""
    texts = collected()
    (FOLDER / "sentences.json").write_text(
        json.dumps(texts[SENTENCES], ensure_ascii=False, indent=0) + "\n", encoding="utf-8"
    )
    for language, code in LANGUAGES.items():
        write_ts(ts_path(language), code, merged(texts, read_ts(ts_path(language))))


def missing(language: str) -> list[str]:
    """Texts without a translation."""
    return list(
        dict.fromkeys(text for said in read_ts(ts_path(language)).values() for text, t in said.items() if not t)
    )


def fill(path: Path) -> int:
    """Put in the translations of a JSON file; how many texts of the source they are."""
    count = 0
    for language, given in json.loads(path.read_text(encoding="utf-8")).items():
        texts = read_ts(ts_path(language))
        for said in texts.values():
            for text in said.keys() & given.keys():
                said[text] = given[text]
                count += 1
        write_ts(ts_path(language), LANGUAGES[language], texts)
    return count


def catalogue(language: str) -> str:
    """What the report says in a language, as JSON."""
    texts = read_ts(ts_path(language))
    used = report_words() | report_tables()
    words = {text: said for text, said in texts[WORDS].items() if said and text in used}
    sentences = {text: said for text, said in texts[SENTENCES].items() if said}
    return json.dumps({"words": words, "sentences": sentences}, ensure_ascii=False, indent=0) + "\n"


def release(folder: Path = FOLDER, catalogues: Path = CATALOGUES) -> None:
    """Make the .qm files with Qt's lrelease, and the catalogues of the report."""
    catalogues.mkdir(exist_ok=True)
    for language in LANGUAGES:
        (catalogues / f"{language}.json").write_text(catalogue(language), encoding="utf-8")
    import PySide6

    names = ("lrelease", "lrelease.exe", "Qt/libexec/lrelease")
    tool = next(path for name in names if (path := Path(PySide6.__path__[0]) / name).exists())
    for source in (*map(ts_path, LANGUAGES), *sorted(FOLDER.glob("qt_*.ts"))):
        target = folder / f"{source.stem}.qm"
        subprocess.run([tool, "-silent", "-removeidentical", source, "-qm", target], check=True)


def main(argv: Sequence[str] | None = None) -> int:
    """Carry out a command."""
    parser = argparse.ArgumentParser(description="Keeps the translation files")
    parser.add_argument("command", choices=("update", "release", "missing", "fill"))
    parser.add_argument("files", nargs="*", type=Path)
    options = parser.parse_args(argv)
    if options.command == "update":
        update()
    elif options.command == "release":
        release()
    elif options.command == "fill":
        print(sum(fill(path) for path in options.files), "texts")
    if options.command in ("update", "missing"):
        lacking = {language: missing(language) for language in LANGUAGES}
        print(json.dumps(lacking, ensure_ascii=False, indent=1))
        return int(any(lacking.values()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
