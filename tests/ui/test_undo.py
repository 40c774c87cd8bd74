"""Undo and redo of drafts."""

from __future__ import annotations

from ui.undo import LIMIT, History


def test_undo_and_redo_walk_through_the_edits() -> None:
    history = History()
    history.record("a", {"a": 1}, {"a": 2})
    history.record("b", {"a": 2}, {"a": 2, "b": 1})
    assert history.undo() == {"a": 2} and history.undo() == {"a": 1} and history.undo() is None
    assert history.redo() == {"a": 2} and history.redo() == {"a": 2, "b": 1} and history.redo() is None


def test_typing_on_in_a_field_is_one_step_named_after_the_last() -> None:
    history = History()
    history.record("to 1", {"a": ""}, {"a": "1"}, "a")
    history.record("to 12", {"a": "1"}, {"a": "12"}, "a")
    assert history.undo_label == "to 12"
    assert history.undo() == {"a": ""} and not history.undo_label


def test_typing_in_a_field_again_later_is_another_step() -> None:
    history = History()
    history.record("to 1", {"a": ""}, {"a": "1"}, "a")
    history.seal()
    history.record("to 12", {"a": "1"}, {"a": "12"}, "a")
    assert history.undo() == {"a": "1"} and history.undo_label == "to 1"


def test_steps_without_a_thread_stay_apart() -> None:
    history = History()
    history.record("Reset", {"a": 1}, {"a": 2})
    history.record("Reset", {"a": 2}, {"a": 3})
    assert history.undo() == {"a": 2}


def test_typing_back_to_the_start_is_no_step() -> None:
    history = History()
    history.record("to 2", {"a": 1}, {"a": 2}, "a")
    history.record("to 1", {"a": 2}, {"a": 1}, "a")
    assert not history.undo_label


def test_a_new_edit_ends_redoing() -> None:
    history = History()
    history.record("a", {"a": 1}, {"a": 2})
    history.undo()
    history.record("b", {"a": 1}, {"a": 1, "b": 1})
    assert not history.redo_label and history.redo() is None


def test_the_past_is_finite_and_can_be_forgotten() -> None:
    history = History()
    for number in range(LIMIT + 10):
        history.record(str(number), {"a": number}, {"a": number + 1})
    steps = 0
    while history.undo() is not None:
        steps += 1
    assert steps == LIMIT
    history.clear()
    assert not history.redo_label
