"""The one error of beespace."""

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


def invalid(message: str, place: str | None = None) -> BeespaceError:
    """An argument that makes no sense."""
    return BeespaceError(message, "invalid_argument", place)
