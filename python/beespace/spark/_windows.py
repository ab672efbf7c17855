"""What workers do with recordings: fixes into windows of time, a window to the engine, its conflicts together.

Borders b cut time into windows. A window has the straight pieces between two fixes that begin at or before
its last instant and end after its first border. So the piece of an agent that goes over a border (begins at
or before it, ends after it) is in both windows, whole, and no other is in two neighbouring windows unless it
goes over their border. Of two agents, the time W in which both are on such a piece is thus the last of the
one window and the first of the other, and the engine finds the same in it: at most one stretch of conflict.
Where there is one, the last stretch of the pair in the one window and the first in the other both contain
it, and are one conflict. Where there is none, the one ends where W begins at the latest, and the other begins
where W ends at the earliest, which is later.

A window with more agents than fit into memory is cut into cells (`_tubes.py`): each pair that is in conflict is
together in the one cell that tells it, with all that the window has of both. So the above holds in cells, too.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from beespace._conflicts import RecordedConflicts
from beespace._errors import BeespaceError
from beespace._recording import Recording
from beespace.spark._blocks import Columns, batches_of, in_metres, reals
from beespace.spark._workers import arrow

_FIXES_AT_ONCE = 1 << 18

# Rows of an agent in a cell of a window.
WINDOW_COLUMNS = ["part", "window", "cell", "role", "id", "first", "fixes"]
WINDOW_SCHEMA = "part int, window int, cell int, role int, id {kind}, first double, fixes binary"
# What an agent is in a cell: near it, at home, or one that goes far.
NEAR, HOME, FAR = range(3)


class Windows:
    """Fixes, sorted by agent and time, into rows of an agent in a window: for `mapInArrow`."""

    def __init__(self, borders: list[float], columns: Columns, max_gap: float) -> None:
        self.borders = np.array(borders, np.float64)
        self.parts = [[0]] * (len(borders) + 1)  # of each window, of each of its cells
        self.columns = columns
        self.max_gap = max_gap

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        pyarrow = arrow()

        waiting: list[Any] = []
        rows = 0
        self._window_before = None
        # The last fix of what came before, and whether a piece leads to it: what follows decides.
        carried: Any = None
        for batch in batches:
            if not batch.num_rows:
                continue
            waiting.append(batch)
            rows += batch.num_rows
            if rows >= _FIXES_AT_ONCE:
                made, carried = self._rows(pyarrow.Table.from_batches(waiting), carried, False)
                yield from made
                waiting, rows = [], 0
        if waiting or carried is not None:
            table = pyarrow.Table.from_batches(waiting) if waiting else carried[0].slice(0, 0)
            yield from self._rows(table, carried, True)[0]

    def _rows(self, table: Any, carried: Any, is_last: bool) -> tuple[list[Any], Any]:
        pyarrow = arrow()

        led_to_first = False
        if carried is not None:
            kept, led_to_first = carried
            table = pyarrow.concat_tables([kept, table])
        table = table.combine_chunks()
        for name in table.column_names:
            if table.column(name).null_count:
                raise BeespaceError(
                    f"a fix has a null for {name}, where there was none when the call was checked: the data "
                    "frame must give the same rows each time",
                    "not_a_number",
                )
        ids: NDArray[Any] = np.asarray(table.column(0).to_numpy())
        times = reals(table.column(1), "time")
        same = ids[1:] == ids[:-1]
        late = np.flatnonzero(same & ~(times[1:] > times[:-1]))
        if len(late):
            at = int(late[0])
            raise BeespaceError(
                f"the agent {ids[at]} has two fixes at {float(times[at])!r} s: of one agent, times must differ",
                "time_order",
                "time",
            )
        pieces = same & (times[1:] - times[:-1] <= self.max_gap)
        leads_to = np.concatenate([[led_to_first], pieces])
        leads_on = np.concatenate([pieces, [False]])
        count = len(ids)
        rest: Any = None
        if not is_last:
            rest = (table.slice(count - 1), bool(leads_to[-1]))
            count -= 1
        # The window of each fix; and those of the fixes before and after, where a piece leads there.
        window = np.searchsorted(self.borders, times, "left")
        before = np.concatenate([window[:1], window[:-1]])
        if carried is not None and led_to_first and self._window_before is not None:
            before[0] = self._window_before
        after = np.concatenate([window[1:], window[-1:]])
        first = np.where(leads_to, before, window)[:count]
        last = np.where(leads_on, after, window)[:count]
        self._window_before = int(window[-2]) if len(window) > 1 else None
        if not count:
            return [], rest
        given = [reals(table.column(2 + at), name)[:count] for at, name in enumerate(self.columns.names)]
        axes = in_metres([np.ascontiguousarray(axis) for axis in given], self.columns)
        fixes = np.column_stack([times[:count], *axes])
        return list(self._emit(table.column(0), ids[:count], fixes, first, last)), rest

    _window_before: int | None = None

    def _emit(
        self,
        column: Any,
        ids: NDArray[Any],
        fixes: NDArray[np.float64],
        first: NDArray[np.int64],
        last: NDArray[np.int64],
    ) -> Iterator[Any]:
        pyarrow = arrow()

        repeats = last - first + 1
        rows = np.repeat(np.arange(len(ids)), repeats)
        behind = np.arange(len(rows)) - np.repeat(np.cumsum(repeats) - repeats, repeats)
        windows = np.repeat(first, repeats) + behind
        order = np.argsort(windows, kind="stable")
        rows, windows = rows[order], windows[order]
        new = (windows[1:] != windows[:-1]) | (ids[rows[1:]] != ids[rows[:-1]])
        begins = np.concatenate([[0], np.flatnonzero(new) + 1])
        data = np.ascontiguousarray(fixes[rows])
        offsets = np.append(begins, len(rows)) * data.shape[1] * 8
        binary = pyarrow.Array.from_buffers(
            pyarrow.binary(),
            len(begins),
            [None, pyarrow.py_buffer(offsets.astype(np.int32)), pyarrow.py_buffer(data)],
        )
        own = windows[begins].astype(np.int32)
        names = column.combine_chunks() if hasattr(column, "combine_chunks") else column
        if hasattr(names, "chunks"):
            names = pyarrow.concat_arrays(names.chunks)
        yield pyarrow.RecordBatch.from_arrays(
            [
                pyarrow.array(np.array([parts[0] for parts in self.parts], np.int32)[own]),
                pyarrow.array(own),
                pyarrow.array(np.zeros(len(begins), np.int32)),
                pyarrow.array(np.full(len(begins), HOME, np.int32)),
                names.take(pyarrow.array(rows[begins])),
                pyarrow.array(data[begins, 0]),
                binary,
            ],
            WINDOW_COLUMNS,
        )


class ConflictsOf:
    """Rows of windows, sorted by window, cell, agent and time, to the conflicts of each: for `mapInArrow`."""

    def __init__(
        self, columns: Columns, unit: float, max_gap: float, arguments: dict[str, Any]
    ) -> None:
        self.columns = columns
        self.unit = unit  # of heights apart, in metres
        self.max_gap = max_gap
        self.arguments = arguments  # of Recording.conflicts

    def __call__(self, batches: Iterator[Any]) -> Iterator[Any]:
        rows: list[tuple[Any, int, bytes]] = []
        current: tuple[int, int] | None = None
        done: set[tuple[int, int]] = set()
        for batch in batches:
            numbers = [batch.column(at).to_pylist() for at in (1, 2, 3)]
            ids, fixes = batch.column(4).to_pylist(), batch.column(6).to_pylist()
            for window, cell, role, id, some in zip(*numbers, ids, fixes):
                if (window, cell) != current:
                    if current is not None:
                        yield from self._search(current[0], rows)
                        done.add(current)
                    current = window, cell
                    if current in done:
                        # An answer without the rest of the cell would be a false all-clear.
                        raise RuntimeError("beespace: the fixes of a window did not come together")
                    rows = []
                rows.append((id, role, some))
        if current is not None:
            yield from self._search(current[0], rows)

    def _search(self, window: int, rows: list[tuple[Any, int, bytes]]) -> Iterator[Any]:
        # Agents by number, in the order of their ids, in which they come.
        numbers: list[int] = []
        names: list[Any] = []
        all_roles: list[int] = []
        for id, role, _ in rows:
            if not names or names[-1] != id:
                names.append(id)
                all_roles.append(role)
            numbers.append(len(names) - 1)
        if len(names) < 2 or HOME not in all_roles:
            return
        found = self._conflicts(np.array(numbers), [some for _, _, some in rows])
        roles = np.array(all_roles)
        i, j = roles[found.i], roles[found.j]
        # A pair belongs to the home of its lower one, or to that of the one that does not go far.
        own = np.flatnonzero((i == HOME) | ((i == FAR) & (j == HOME)))
        if not len(own):
            return
        first = np.array([names[at] for at in found.i[own].tolist()])
        second = np.array([names[at] for at in found.j[own].tolist()])
        columns = [
            first,
            second,
            np.full(len(first), window, np.int32),
            found.begin[own],
            found.end[own],
            found.closest_time[own],
            found.closest_distance[own],
        ]
        yield from batches_of(
            ["first", "second", "window", "begin", "end", "closest_time", "closest_distance"], columns
        )

    def _conflicts(self, numbers: NDArray[np.int64], fixes: list[bytes]) -> RecordedConflicts:
        each = 1 + self.columns.width
        table = np.frombuffer(b"".join(fixes)).reshape(-1, each)
        agents = np.repeat(numbers, [len(some) // (8 * each) for some in fixes])
        places = table[:, 1 : 1 + self.columns.searched]
        apart: dict[str, Any] = {}
        if self.columns.apart:
            apart = {"heights": table[:, -1], "height_unit": self.unit}
        recording = Recording(agents, np.ascontiguousarray(table[:, 0]), places, **apart)
        gap = None if np.isinf(self.max_gap) else self.max_gap
        return recording.conflicts(max_gap=gap, **self.arguments)


def join_conflicts(batches: Iterator[Any]) -> Iterator[Any]:
    """Stretches of conflict, sorted by pair, window and begin, to conflicts: what goes on over a border is
    one."""
    pyarrow = arrow()

    names = ["first", "second", "begin", "end", "closest_time", "closest_distance"]
    open_one: list[Any] | None = None
    last: Any = None
    for batch in batches:
        joined: list[list[Any]] = []
        for row in zip(*(column.to_pylist() for column in batch.columns)):
            first, second, window, begin, end, time, distance = row
            if (
                open_one is not None
                and open_one[:2] == [first, second]
                and window == open_one[2] + 1
                and begin <= open_one[4]
            ):
                open_one[2], open_one[4] = window, end
                if distance < open_one[6]:
                    open_one[5:] = [time, distance]
                continue
            if open_one is not None:
                joined.append(open_one)
            open_one = list(row)
        if joined:
            yield _batch_of(joined, batch, names, pyarrow)
        last = batch
    if open_one is not None:
        yield _batch_of([open_one], last, names, pyarrow)


def _batch_of(rows: list[list[Any]], like: Any, names: list[str], pyarrow: Any) -> Any:
    columns = list(zip(*rows))
    del columns[2]
    types = [like.schema.field(name).type for name in names]
    return pyarrow.RecordBatch.from_arrays(
        [pyarrow.array(column, type=kind) for column, kind in zip(columns, types)], names
    )
