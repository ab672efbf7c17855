"""Pages about points and recordings, as `beespace report` makes them."""

from __future__ import annotations

import ctypes
import html
import os
from collections.abc import Sequence
from typing import Any

from beespace import _io_library, _library
from beespace._calls import length, run_of, whole
from beespace._checks import gap_of
from beespace._errors import invalid
from beespace._file_points import FilePoints
from beespace._files import (
    PathLike,
    encoded_path,
    paths_of,
    reading_options,
    set_numbers,
)
from beespace._points import Points, PointsLike
from beespace._ranges import above_zero
from beespace._view import is_notebook, show_in_browser, show_in_notebook

# How many points a file has, before it is read: enough to be watched for Ctrl-C.
_unknown = 2**62


class Report:
    """A page: one file of HTML that opens without a network. A notebook shows it.

    Attributes
    ----------
    html : str
        The page.
    notes : tuple of str
        How the input was read, and what is left out; the page says it, too.
    risky : bool
        Whether it shows a danger: points at risk, conflicts, or gaps and records left out that may
        hide one.

    Examples
    --------
    >>> import beespace
    >>> page = beespace.report([[0, 0, 0], [3, 4, 0], [99, 0, 0]], 10)
    >>> page.risky, page.html[:15]
    (True, '<!doctype html>')
    """

    __slots__ = ("_handle", "notes", "risky")

    def __init__(self, handle: ctypes.c_void_p) -> None:
        at_once = _io_library.load().at_once
        self._handle = handle
        count = at_once.beespace_io_page_note_count(handle)
        self.notes = tuple(
            at_once.beespace_io_page_note(handle, each).decode(errors="replace")
            for each in range(count)
        )
        self.risky = bool(at_once.beespace_io_page_risky(handle))

    @property
    def html(self) -> str:
        size = ctypes.c_size_t()
        address = _io_library.load().at_once.beespace_io_page_html(
            self._handle, ctypes.byref(size)
        )
        return ctypes.string_at(address, size.value).decode(errors="replace")

    def save(self, path: PathLike) -> None:
        """Writes the page into a file, which is there whole or not at all.

        Parameters
        ----------
        path : str or path
            The file; one that is there is replaced, but not one that the page was made of.

        Raises
        ------
        BeespaceOSError
            The file cannot be written.

        Examples
        --------
        >>> import beespace, os, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     beespace.report([[0, 0, 0], [3, 4, 0]], 10).save(f"{folder}/page.html")
        ...     print(os.listdir(folder))
        ['page.html']
        """
        error = _io_library.new_error()
        code = _io_library.load().unlocked.beespace_io_page_write(
            self._handle, encoded_path(path), ctypes.byref(error)
        )
        _io_library.check(code, error)

    def view(self) -> None:
        """Shows the page: in a notebook below the cell, elsewhere in a browser.

        The browser fetches it from this process, on this machine; it can be loaded anew as long as
        the process is there. To keep it, `save` it.

        Raises
        ------
        BeespaceError
            No browser has fetched it within a minute.

        Examples
        --------
        >>> import beespace
        >>> page = beespace.report([[0, 0, 0], [3, 4, 0]], 10)
        >>> page.view()  # doctest: +SKIP
        >>> page
        <Report: a danger is shown>
        """
        if is_notebook():
            show_in_notebook(self)
        else:
            show_in_browser(self.html)

    def _repr_html_(self) -> str:
        # In a frame of its own, whose scripts see nothing of the notebook.
        return (
            '<iframe sandbox="allow-scripts allow-downloads" '
            'style="width: 100%; height: 640px; border: 0" '
            f'srcdoc="{html.escape(self.html)}"></iframe>'
        )

    def __repr__(self) -> str:
        danger = "a danger is shown" if self.risky else "no danger in what is known"
        return f"<Report: {danger}>" if not self.notes else (
            f"<Report: {danger}" + "".join(f"\n  {note}" for note in self.notes) + ">"
        )


def report(
    points: PathLike | Sequence[PathLike] | FilePoints | PointsLike,
    threshold: float,
    *,
    output: PathLike | None = None,
    title: str | None = None,
    ids: Sequence[object] | None = None,
    vertical: float | str | None = None,
    inclusive: bool = False,
    max_gap: float | None = None,
    ignore_below: float | None = None,
    threads: int = 1,
    frame: str | None = None,
    columns: str | None = None,
    units: str | None = None,
    heights: str | None = None,
    time_unit: str | None = None,
    one_clock: bool = False,
    time_zone: str | None = None,
    dates: str | None = None,
    fps: float | None = None,
    scale: str | None = None,
    least_likelihood: float | None = None,
    tolerance: float | None = None,
    skip_bad: bool = False,
    grounded: bool = False,
) -> Report:
    """Makes a page about points or a recording, in three dimensions, with the worst pairs and, of
    recordings, the time. It is the page of `beespace report`.

    Parameters
    ----------
    points : str or path, a list of them, FilePoints, or points
        A file with points or a recording; files or a folder that are one recording; what `read`
        gave; or positions in metres, z up, as all questions take them.
    threshold : float
        How close is too close, in metres.
    output : str or path, optional
        A file to write the page into; as `Report.save`.
    title : str, optional
        What the page is called; otherwise the name of the file.
    ids : sequence, optional
        What each point is called, of points that are positions; otherwise their indices.
    vertical : float or str, optional
        A vertical threshold, in metres, or a text with its unit: "1000ft".
    inclusive : bool
        Whether exactly the threshold apart counts as closer.
    max_gap : float, optional
        Of recordings: between fixes farther apart in time, in seconds, nothing is known; otherwise
        five times the typical interval. Infinity joins all fixes.
    ignore_below : float, optional
        Of recordings: as of `FileRecording.conflicts`.
    threads : int
        How many threads may work; 0 for one per processor.
    frame, columns, units, heights, time_unit, one_clock, time_zone, dates, fps, scale, least_likelihood, tolerance, skip_bad, grounded
        How files are read: as in `read` and `read_recording`.

    Returns
    -------
    Report
        The page. `_repr_html_` shows it in a notebook.

    Ctrl-C ends the search for what is on it; it is not heard while a file is read.

    Raises
    ------
    BeespaceFileError, BeespaceOSError, ImportError
        As `read`.

    Examples
    --------
    >>> import beespace
    >>> beespace.report([[0, 0, 0], [300, 400, 0]], 10)
    <Report: no danger in what is known>
    """
    io = _io_library.load()
    if ignore_below is not None and not _are_paths(points):
        raise invalid("points take off nowhere: this is for recordings in files", "ignore_below")
    page_options = _page_options(
        threshold, title, vertical, inclusive, max_gap, ignore_below, threads
    )
    handle, error = io.handles["page"](), _io_library.new_error()
    tail = (page_options, ctypes.byref(handle), ctypes.byref(error))
    texts = {
        "frame": frame, "columns": columns, "units": units, "heights": heights,
        "time_unit": time_unit, "time_zone": time_zone, "dates": dates, "scale": scale,
    }
    if _are_paths(points):
        if ids is not None:
            raise invalid("files have ids of their own: name their column with columns=", "ids")
        paths = paths_of(points)  # type: ignore[arg-type]
        options = reading_options(skip_bad, grounded, 1, one_clock=one_clock, **texts)
        set_numbers(options, fps, least_likelihood, tolerance)
        code = io.unlocked.beespace_io_page_of_files(paths, len(paths), ctypes.byref(options), *tail)
    else:
        numbers = {"fps": fps, "least_likelihood": least_likelihood, "tolerance": tolerance}
        flags = {
            "skip_bad": skip_bad or None, "grounded": grounded or None,
            "one_clock": one_clock or None,
        }
        for name, given in {**texts, **numbers, **flags}.items():
            if given is not None:
                raise invalid("this says how a file is read, and these points are read", name)
        if isinstance(points, FilePoints) and ids is None:
            code = io.unlocked.beespace_io_page_of_read(points, *tail)
        else:
            code = _page_of_points(io, points, ids, tail)
    if error.place == b"page_options":
        error.place = b"vertical"  # all others have been looked at
    _io_library.check(code, error)
    made = Report(handle)
    if output is not None:
        made.save(output)
    return made


def view(points: Any, threshold: float, **options: Any) -> None:
    """Shows a page about points or a recording: in a notebook below the cell, elsewhere in a browser.

    Parameters
    ----------
    points, threshold
        As of `report`.
    **options
        All others of `report`.

    Raises
    ------
    BeespaceError
        As `report` and `Report.view`.

    Examples
    --------
    >>> import beespace
    >>> beespace.view([[0, 0, 0], [3, 4, 0]], 10, title="Two drones")  # doctest: +SKIP
    >>> try:
    ...     beespace.view([[0, 0, 0], [3, 4, 0]], -1)
    ... except beespace.BeespaceError as error:
    ...     print(error.code)
    invalid_threshold
    """
    report(points, threshold, **options).view()


def _page_of_points(io: Any, points: Any, ids: Any, tail: tuple[Any, ...]) -> int:
    if getattr(points, "frame", None) == "wgs84":
        raise invalid("points in degrees have their own ids: leave ids out", "ids")
    given = Points(points, "points")
    names = None
    if ids is not None:
        texts = [_name(each) for each in ids]
        if len(texts) != given.count:
            raise invalid(f"there are {given.count} points and {len(texts)} ids", "ids")
        names = (ctypes.c_char_p * len(texts))(*texts)
    return int(io.unlocked.beespace_io_page_of_points(ctypes.byref(given.struct), names, *tail))


def _name(name: object) -> bytes:
    text = str(name)
    if "\0" in text:
        raise invalid("an id has no zero byte in it", "ids")
    return text.encode(errors="backslashreplace")


def _are_paths(points: Any) -> bool:
    kinds = (str, bytes, os.PathLike)
    several: Any = (list, tuple)
    if isinstance(points, several):
        return any(isinstance(each, kinds) for each in points)
    return isinstance(points, kinds)


def _page_options(
    threshold: Any,
    title: Any,
    vertical: Any,
    inclusive: bool,
    max_gap: Any,
    ignore_below: Any,
    threads: Any,
) -> Any:
    options = _io_library.CPageOptions(ctypes.sizeof(_io_library.CPageOptions))
    options.flags = _library.INCLUSIVE if inclusive else 0
    number = whole(threads, "threads")
    options.threads = _library.ALL_PROCESSORS if number == 0 else min(number, 256)
    options.threshold_m = length(threshold, "threshold")
    if max_gap is not None:
        options.max_gap_s = gap_of(max_gap)
    if ignore_below is not None:
        options.ignore_below_m = above_zero(length(ignore_below, "ignore_below"), "ignore_below")
    if vertical is not None:
        text = vertical if isinstance(vertical, str) else repr(length(vertical, "vertical"))
        options.vertical = _io_library.encoded(text)
    options.title = _io_library.encoded(title)
    run = run_of(1, _unknown)
    if run is not None:
        options.run = ctypes.pointer(run)
    return ctypes.byref(options)
