"""The state of the window, without a window."""

from __future__ import annotations

from pathlib import Path

import pytest

from gearstudio.catalogue import METHOD_IDS as CATALOGUE_IDS
from gearstudio.design import Design, design_mapping
from tests.ui.stand_ins import result
from ui.formatting import METHOD_TITLES
from ui.session import Failure, Key, Session, flatten, nest

TEETH = "pair.pinion_teeth"
KEY = Key("wheel", "point_cloud", "optimised")


@pytest.fixture
def session() -> Session:
    made = Session()
    made.load(Design())
    return made


def test_a_draft_is_the_design_file_in_other_words() -> None:
    design = Design()
    assert nest(flatten(design))["pair"] == {k: v for k, v in design_mapping(design)["pair"].items() if v is not None}
    assert flatten(design)["blank.wheel.bore_diameter"] is None


def test_a_good_edit_becomes_the_design(session: Session) -> None:
    changed = []
    session.design_changed.connect(changed.append)
    session.edit(TEETH, 19)
    assert changed == [session.design]
    assert session.design.pair.pinion_teeth == 19 == session.pair.pinion.teeth
    assert session.unsaved


def test_a_bad_edit_leaves_the_last_good_design(session: Session) -> None:
    session.edit(TEETH, 19)
    session.edit(TEETH, "nineteen")
    assert session.design.pair.pinion_teeth == 19
    assert session.draft[TEETH] == "nineteen"
    assert [issue.field for issue in session.issues] == [TEETH]
    session.edit(TEETH, 21)
    assert session.issues == () and session.design.pair.pinion_teeth == 21


def test_all_problems_are_found_at_once(session: Session) -> None:
    session.edit(TEETH, 3)
    session.edit("pair.outer_module", -1)
    session.edit("lengthwise.spiral_angle_deg", "steep")
    assert {issue.field for issue in session.issues} == {TEETH, "pair.outer_module", "lengthwise.spiral_angle_deg"}


def test_an_edit_that_changes_nothing_is_silent(session: Session) -> None:
    session.edit(TEETH, "x")
    heard = []
    session.design_changed.connect(heard.append)
    session.edit(TEETH, 17)
    assert heard == [], "the design is the one there was"
    assert session.issues == ()


def test_results_of_an_earlier_design_are_kept_but_not_current(session: Session) -> None:
    session.put_result(session.design, result(KEY))
    assert KEY in session.current
    session.edit(TEETH, 18)
    assert KEY in session.results and KEY not in session.current and KEY in session.missing_keys()


def test_a_result_that_comes_too_late_is_dropped(session: Session) -> None:
    earlier = session.design
    session.edit(TEETH, 18)
    session.put_result(earlier, result(KEY))
    session.put_failure(earlier, KEY, Failure("no", ""))
    assert not session.results and not session.current and not session.failures


def test_visible_variants_are_wanted_first(session: Session) -> None:
    session.select(method="point_cloud", variant="published")
    assert session.missing_keys()[0] == Key("wheel", "point_cloud", "published")
    session.select(method="all")
    assert [key.method for key in session.missing_keys()[:3]] == list(CATALOGUE_IDS)
    assert {key.variant for key in session.missing_keys()[:3]} == {"published"}
    assert len(session.missing_keys()) == 6


def test_a_failure_replaces_an_older_result_and_is_not_tried_again(session: Session) -> None:
    session.put_result(session.design, result(KEY))
    session.put_failure(session.design, KEY, Failure("the sections cross", "trace"))
    assert KEY not in session.results and KEY not in session.missing_keys()
    session.forget_results()
    assert KEY in session.missing_keys()


def test_a_cancelled_build_keeps_the_older_result(session: Session) -> None:
    session.put_result(session.design, result(KEY))
    session.edit(TEETH, 18)
    session.put_cancelled(session.design, KEY)
    assert KEY in session.results and KEY not in session.current and KEY not in session.missing_keys()


def test_building_is_told_for_the_one_that_begins_and_the_one_that_ends(session: Session) -> None:
    heard = []
    session.results_changed.connect(heard.append)
    session.put_building(KEY)
    session.put_result(session.design, result(KEY))
    assert heard == [KEY, KEY] and session.building is None


def test_loading_starts_afresh(session: Session) -> None:
    session.put_result(session.design, result(KEY))
    session.edit(TEETH, "x")
    session.load(Design(), Path("some.gear.toml"))
    assert not session.results and session.issues == () and not session.unsaved
    assert session.title == "some.gear.toml"


def test_saving_and_restoring_a_draft(session: Session) -> None:
    before = dict(session.draft)
    session.edit(TEETH, 20)
    session.mark_saved(Path("a.gear.toml"), session.design)
    assert not session.unsaved
    session.restore(before)
    assert session.unsaved and session.design.pair.pinion_teeth == 17


def test_selecting_the_same_again_is_silent(session: Session) -> None:
    heard = []
    session.selection_changed.connect(lambda: heard.append(1))
    session.select(member="wheel")
    session.select(member="pinion")
    assert heard == [1]


def test_every_method_has_a_title() -> None:
    assert tuple(METHOD_TITLES) == CATALOGUE_IDS
