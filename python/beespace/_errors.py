"""The errors of beespace: one, and two more of files."""

from __future__ import annotations


class BeespaceError(ValueError):
    """What is wrong with the points or options of a call, where, and what to do about it.

    Attributes
    ----------
    code : str
        The kind of the error: "invalid_threshold", "not_finite", "too_many_results", ... The names
        are those of the command and of the C library.
    place : str or None
        The argument that it is about: "points", "others", "places"; None where it is about none.
    record : int or None
        The index into `place` that it is about; None where it is about none.

    Examples
    --------
    >>> import beespace
    >>> try:
    ...     beespace.at_risk([[0, 0, 0], [1, float("nan"), 0]], 5)
    ... except beespace.BeespaceError as error:
    ...     print(error.code, error.place, error.record)
    not_finite points 1
    """

    code: str
    place: str | None
    record: int | None

    def __init__(
        self, message: str, code: str, place: str | None = None, record: int | None = None
    ) -> None:
        where = "" if place is None else place if record is None else f"{place}[{record}]"
        super().__init__(f"{where}: {message}" if where else message)
        self.code = code
        self.place = place
        self.record = record

    def __reduce__(self) -> tuple[object, ...]:
        return (_restore, (self.args, self.code, self.place, self.record))


def _restore(
    args: tuple[object, ...], code: str, place: str | None, record: int | None
) -> BeespaceError:
    """An error as it was before it was pickled, as it is from process to process."""
    error = BeespaceError.__new__(BeespaceError, *args)
    error.args = args
    error.code = code
    error.place = place
    error.record = record
    return error


class BeespaceFileError(BeespaceError):
    """What is wrong with a file, where in it, and what to do about it.

    Attributes
    ----------
    code : str
        The kind of the error: "not_a_number", "unknown_frame", "truncated", ...
    file : str or None
        The file that it is about; of an archive with the name in it, "show.skyc!drone1.json".
    line : int or None
        The line of the file, from 1.
    column : int or None
        The field of the record, from 1.
    record : int or None
        The row of data, from 0; or the index into `place`.
    place : str or None
        The argument that it is about, where it is about one: "options", "path".

    Examples
    --------
    >>> import beespace
    >>> try:
    ...     beespace.read("../examples/data/cage.csv", columns="x=1,y=2,z=9")
    ... except beespace.BeespaceFileError as error:
    ...     print(error.code)
    missing_column
    """

    file: str | None
    line: int | None
    column: int | None

    def __init__(
        self,
        text: str,
        code: str,
        place: str | None = None,
        record: int | None = None,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
    ) -> None:
        super().__init__(text, code)
        self.place = place
        self.record = record
        self.file = file
        self.line = line
        self.column = column

    def __reduce__(self) -> tuple[object, ...]:
        return (_restore_of_file, (type(self), self.args[0], self.code, self._more()))

    def _more(self) -> dict[str, object]:
        """The attributes, those that were added, too."""
        return dict(self.__dict__)


class BeespaceOSError(BeespaceFileError, OSError):
    """A file that the system does not open, read or write: also an OSError, with `filename`, and
    with `errno` where that is known.

    Examples
    --------
    >>> import beespace
    >>> try:
    ...     beespace.read("not-there.csv")
    ... except OSError as error:
    ...     print(error)
    not-there.csv: there is no such file; check the name and the folder
    """

    def __str__(self) -> str:
        return str(self.args[0])

    def _more(self) -> dict[str, object]:
        return {**super()._more(), "errno": self.errno, "filename": self.filename}


def _restore_of_file(
    kind: type[BeespaceFileError], text: str, code: str, attributes: dict[str, object]
) -> BeespaceFileError:
    error = kind(text, code)
    for name, value in attributes.items():
        setattr(error, name, value)
    return error


def invalid(message: str, place: str | None = None) -> BeespaceError:
    """An argument that makes no sense."""
    return BeespaceError(message, "invalid_argument", place)
