"""The report: a PDF with the sections asked for, from the numbers of the design."""

import json
import re
from dataclasses import replace

import pytest

from gearstudio.catalogue import METHOD_INFOS
from gearstudio.design import Design
from gearstudio.report.blocks import Pages, Picture, Table, Text
from gearstudio.report.chapters import chapter
from gearstudio.report.content import gather
from gearstudio.report.document import Order, compose, typeset
from gearstudio.report.sections import SECTION_KEYS
from gearstudio.report.store import Store, Taken

pytestmark = pytest.mark.kernel


def _quiet(stage: str, fraction: float) -> None:
    """Takes progress and says nothing."""


def _page_count(pdf: bytes) -> int:
    return len(re.findall(rb"/Type\s*/Page\b", pdf))


def test_the_table_of_the_comparison_holds_the_built_deviations() -> None:
    content = gather(Design(), "pinion", ("comparison",), _quiet)
    table = next(block for block in chapter("comparison", content, Store()).blocks if isinstance(block, Table))
    shown, member = {}, ""
    for row in table.rows:
        member = row[0].lower() if len(row) == 1 else member
        shown[(member, *row[:2])] = row[2:]
    for (member, method, variant), result in content.results.items():
        title = next(info.title for info in METHOD_INFOS if info.id == method)
        largest = float(shown[(member, title, variant)][0])
        assert largest == pytest.approx(result.statistics.max_um, rel=0.006)


def test_a_variant_that_cannot_be_built_is_told_with_the_reason() -> None:
    key = ("wheel", "profile_sweep", "published")
    content = replace(gather(Design(), "wheel", ("design",), _quiet), failures={key: "the profile crosses itself"})
    blocks = chapter("comparison", content, Store()).blocks
    assert any("crosses itself" in block.text for block in blocks if isinstance(block, Text))
    assert any("not built" in row for block in blocks if isinstance(block, Table) for row in block.rows)


def test_only_the_sections_wanted_are_computed() -> None:
    content = gather(Design(), "wheel", ("design", "sheet"), _quiet)
    assert not content.results and content.contact is None and content.sheet is not None


def test_every_picture_named_is_there() -> None:
    content = gather(Design(), "wheel", SECTION_KEYS, _quiet)
    store = Store(Taken({"views": b"png"}))
    for key in ("comparison", "pictures", "deviation", "curvature", "contact"):
        for block in chapter(key, content, store).blocks:
            if isinstance(block, Picture):
                assert block.file in store.files


def test_marks_of_the_typesetter_in_a_name_stay_text() -> None:
    pages = Pages('#panic("no") $x$ *b* "q" \\ 螺旋', (("Note", "#[a] = $ b"),), ())
    assert json.loads(json.dumps(pages.data()))["title"].startswith("#panic")
    assert typeset(pages)[0].startswith(b"%PDF")
    assert all(page.startswith(b"\x89PNG") for page in typeset(pages, 40))


@pytest.mark.slow
def test_a_whole_report_reports_its_progress() -> None:
    said: list[tuple[str, float]] = []
    design = Design()
    order = Order(("design", "comparison", "contact"), "pinion")
    pages = compose(design, order, Taken, lambda *x: said.append(x))
    pdf = typeset(pages)[0]
    assert pdf.startswith(b"%PDF") and _page_count(pdf) >= 3
    fractions = [fraction for _, fraction in said]
    assert fractions == sorted(fractions) and fractions[0] == 0.0
