"""Newest request wins, exports stay, a killer gets two attempts."""

from __future__ import annotations

from tests.worker.fake_jobs import Echo, Export
from ui.job_queue import JobQueue, Ticket


def builds(*values: object) -> list[Echo]:
    return [Echo(value) for value in values]


def drained(queue: JobQueue) -> list[object]:
    values = []
    while (ticket := queue.take()) is not None:
        values.append(ticket.job.value)  # type: ignore[attr-defined]
        queue.finish()
    return values


def test_jobs_of_a_request_keep_their_order() -> None:
    queue = JobQueue()
    queue.submit(builds(1, 2, 3), 1, True)
    assert queue.wanted == 3
    assert drained(queue) == [1, 2, 3]


def test_a_newer_request_replaces_what_waits_and_supersedes_what_runs() -> None:
    queue = JobQueue()
    queue.submit(builds(1, 2), 1, True)
    queue.take()
    queue.submit(builds(3, 4), 2, True)
    assert queue.running is not None and queue.running.superseded
    assert queue.wanted == 2
    assert queue.finish() is None
    assert drained(queue) == [3, 4]


def test_without_replacing_requests_queue_up() -> None:
    queue = JobQueue()
    queue.submit(builds(1), 1, True)
    queue.submit(builds(2), 2, False)
    assert drained(queue) == [1, 2]


def test_exports_and_builds_leave_each_other_alone_and_exports_replace_nothing() -> None:
    queue = JobQueue()
    queue.submit([Export(0.0, "a")], 1, True)
    queue.submit(builds(1), 2, True)
    queue.submit([Export(0.0, "b")], 3, True)
    queue.submit(builds(2), 4, True)
    assert drained(queue) == ["a", "b", 2]


def test_a_job_whose_process_dies_gets_another_attempt_before_the_others_but_not_a_third() -> None:
    queue = JobQueue()
    queue.submit(builds(1, 2), 1, True)
    first = queue.take()
    assert queue.retry() is None
    assert queue.take() is first
    assert queue.retry() is first
    assert drained(queue) == [2]


def test_a_superseded_job_whose_process_dies_is_forgotten() -> None:
    queue = JobQueue()
    queue.submit(builds(1), 1, True)
    queue.take()
    queue.submit(builds(2), 2, True)
    assert queue.retry() is None
    assert drained(queue) == [2]


def test_a_job_put_back_comes_first_and_keeps_its_attempts() -> None:
    queue = JobQueue()
    queue.submit(builds(1, 2), 1, True)
    queue.take()
    queue.put_back()
    assert drained(queue) == [1, 2]


def test_clearing_returns_what_was_awaited_the_running_one_first() -> None:
    queue = JobQueue()
    queue.submit(builds(1, 2), 1, True)
    queue.take()
    assert [ticket.job for ticket in queue.clear()] == builds(1, 2)
    assert queue.wanted == 0 and queue.running is None


def test_clearing_passes_over_a_superseded_job() -> None:
    queue = JobQueue()
    queue.running = Ticket(Echo(1), 1, superseded=True)
    assert queue.clear() == []
