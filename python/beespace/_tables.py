"""Answers that are columns of one length."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

if TYPE_CHECKING:
    import pandas
    import polars


def plural(count: int, one: str) -> str:
    return f"{count:,} {one}" if count == 1 else f"{count:,} {one}s"


class Table:
    """Columns of one length."""

    __slots__ = ()

    def columns(self) -> dict[str, NDArray[Any]]:
        """Each array by its name.

        Examples
        --------
        >>> import beespace
        >>> list(beespace.pairs([[0, 0], [3, 4]], 6).columns())
        ['i', 'j', 'distance']
        """
        raise NotImplementedError

    def to_pandas(self) -> pandas.DataFrame:
        """As a data frame of pandas, which must be installed.

        Returns
        -------
        pandas.DataFrame
            A column for each array, without a copy; none for what was not asked for.

        Examples
        --------
        >>> import beespace
        >>> frame = beespace.pairs([[0, 0], [3, 4]], 6).to_pandas()
        >>> frame.columns.tolist()
        ['i', 'j', 'distance']
        """
        import pandas

        return pandas.DataFrame(self.columns(), copy=False)

    def to_polars(self) -> polars.DataFrame:
        """As a data frame of Polars, which must be installed.

        Returns
        -------
        polars.DataFrame
            A column for each array; none for what was not asked for.

        Examples
        --------
        >>> import beespace
        >>> beespace.pairs([[0, 0], [3, 4]], 6).to_polars().columns
        ['i', 'j', 'distance']
        """
        import polars

        return polars.DataFrame(self.columns())
