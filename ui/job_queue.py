"""Which job comes next: the newest request wins, exports are always carried out. Plain data, one thread."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

from gearstudio.jobs import Job

ATTEMPTS = 2
"""A job whose process dies this often is given up."""


@dataclass
class Ticket:
    """A job of a request in the queue; requests are numbered upwards."""

    job: Job
    request: int
    attempts: int = 0
    superseded: bool = False


class JobQueue:
    """Jobs that wait, and the one that runs.

    Only its user decides when to take the next job; a superseded job that runs stays until it ends.
    """

    def __init__(self) -> None:
        self._pending: deque[Ticket] = deque()
        self.running: Ticket | None = None

    @property
    def wanted(self) -> int:
        """Number of jobs whose result is still awaited."""
        running = self.running is not None and not self.running.superseded
        return len(self._pending) + running

    def submit(self, jobs: Sequence[Job], request: int, replace: bool) -> None:
        """Append the jobs of a request; with ``replace``, drop those of older requests that it supersedes."""
        if replace:
            purposes = {job.purpose for job in jobs} - {"export"}
            self._pending = deque(ticket for ticket in self._pending if ticket.job.purpose not in purposes)
            if self.running is not None and self.running.job.purpose in purposes:
                self.running.superseded = True
        self._pending.extend(Ticket(job, request) for job in jobs)

    def take(self) -> Ticket | None:
        """Make the next job the running one."""
        self.running = self._pending.popleft() if self._pending else None
        return self.running

    def finish(self) -> Ticket | None:
        """The running job has ended; return it if its result is awaited."""
        ticket, self.running = self.running, None
        return None if ticket is None or ticket.superseded else ticket

    def retry(self) -> Ticket | None:
        """The process died under the running job: let it have another attempt, or return it as given up."""
        ticket = self.finish()
        if ticket is None:
            return None
        ticket.attempts += 1
        if ticket.attempts >= ATTEMPTS:
            return ticket
        self._pending.appendleft(ticket)
        return None

    def put_back(self) -> None:
        """The process was ended on purpose: the running job comes first again."""
        ticket = self.finish()
        if ticket is not None:
            self._pending.appendleft(ticket)

    def clear(self) -> list[Ticket]:
        """Forget everything; return the jobs whose result was awaited, the running one first."""
        running = self.finish()
        tickets = ([running] if running else []) + list(self._pending)
        self._pending.clear()
        return tickets
