"""Pictures of points through Matplotlib."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from beespace._answers import Pairs
from beespace._errors import invalid
from beespace._file_points import FilePoints
from beespace._points import Points, PointsLike
from beespace._searches import Searches
from beespace._tables import plural

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# So many lines are drawn in a few seconds.
_most_lines = 100_000
_calm, _danger = "#5f7d95", "#d1350f"
_many = 20_000  # points, which smaller dots show better


def plot(
    points: PointsLike | FilePoints,
    answer: float | Pairs | NDArray[Any] | None = None,
    *,
    others: PointsLike | None = None,
    vertical: float | None = None,
    inclusive: bool = False,
    projection: Literal["3d"] | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Draws points, seen from above or in three dimensions, with those at risk and their pairs.

    Matplotlib must be installed: ``pip install beespace[plot]``.

    Parameters
    ----------
    points : points, as all questions take them, or FilePoints
        What is drawn: metres; of a file in degrees longitude and latitude, and the height.
    answer : float, Pairs, or array, optional
        What is highlighted: the pairs that are closer than a threshold in metres, which are looked
        for; pairs that were found; or ids or flags of points, as `at_risk` gives them.
    others : points, optional
        Another set, drawn as crosses: pairs are those between both.
    vertical, inclusive
        Of a threshold, as `at_risk` says.
    projection : "3d", optional
        Three dimensions; otherwise x and y. Seen from above, points above each other look close.
    ax : matplotlib.axes.Axes, optional
        Where to draw; otherwise in a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        With labels, and a legend that says how many there are: more than 100,000 pairs are counted
        there, and not drawn as lines. A metre is as long on each axis.

    Raises
    ------
    BeespaceError
        An answer that is not about these points.
    ImportError
        Matplotlib is missing.

    Examples
    --------
    >>> import beespace
    >>> drones = [[0, 0, 50], [80, 60, 50], [300, 0, 50], [300, 0, 149.9]]
    >>> axes = beespace.plot(drones, 100)
    >>> [each.get_text() for each in axes.get_legend().get_texts()]
    ['1 pair', '4 points', '2 at risk']
    """
    first = _Drawn(points, "points")
    second = None if others is None else _Drawn(others, "others")
    if second is not None and second.degrees != first.degrees:
        raise invalid("degrees and metres do not fit into one picture", "others")
    pairs, ids = _highlighted(points, answer, others, vertical, inclusive)
    if pairs is not None:
        _check_pairs(pairs, first, second)
        ids = np.unique(pairs.i if second is not None else np.concatenate([pairs.i, pairs.j]))
    flags = _flags(ids, len(first.places))
    canvas = _Canvas(_axes(ax, projection))
    if pairs is not None and len(pairs):
        canvas.lines(first.places[pairs.i], (second or first).places[pairs.j], len(pairs))
    canvas.dots(first.places[~flags], _calm, plural(len(flags), "point"))
    if answer is not None:
        canvas.dots(first.places[flags], _danger, f"{int(flags.sum()):,} at risk")
    if second is not None:
        canvas.dots(second.places, _calm, plural(len(second.places), "other"), "x")
    canvas.finish(first, second)
    return canvas.ax


class _Drawn:
    """The places of a set in the picture."""

    def __init__(self, points: Any, place: str) -> None:
        self.degrees = getattr(points, "frame", None) == "wgs84"
        given = Points(points.degrees if self.degrees else points, place)
        self.places = given.rows()
        if not np.isfinite(self.places).all():
            row = int((~np.isfinite(self.places)).any(axis=1).argmax())
            raise invalid(f"point {row} is not finite", place)


def _highlighted(
    points: Any, answer: Any, others: Any, vertical: Any, inclusive: bool
) -> tuple[Pairs | None, NDArray[Any] | None]:
    found = isinstance(answer, Pairs)
    if found or answer is None or np.ndim(answer) == 1:
        if vertical is not None or inclusive:
            raise invalid("vertical and inclusive need a threshold")
        if found:
            return answer, None
        return None, None if answer is None else np.asarray(answer)
    search = Searches().pairs
    return search(
        points, answer, others=others, distances=False, vertical=vertical, inclusive=inclusive
    ), None


def _check_pairs(pairs: Pairs, first: _Drawn, second: _Drawn | None) -> None:
    if pairs.is_between != (second is not None):
        told = "two sets: give the other one, too, as others" if second is None else "one set"
        raise invalid(f"these pairs are of {told}", "answer")
    if pairs.shape != (len(first.places), len((second or first).places)):
        raise invalid(f"these pairs are of {pairs.shape[0]:,} points", "answer")


def _flags(ids: NDArray[Any] | None, count: int) -> NDArray[np.bool_]:
    if ids is not None and ids.dtype == bool:
        if len(ids) != count:
            raise invalid(f"there are {len(ids):,} flags for {count:,} points", "answer")
        return ids
    flags = np.zeros(count, bool)
    if ids is not None and len(ids):
        if ids.dtype.kind not in "iu" or ids.min() < 0 or ids.max() >= count:
            raise invalid(f"ids are whole numbers from 0 to {count - 1:,}", "answer")
        flags[ids] = True
    return flags


def _axes(ax: Any, projection: str | None) -> Any:
    if projection not in (None, "3d"):
        raise invalid(f'this is "3d" or left out, not {projection!r}', "projection")
    if ax is None:
        try:
            pyplot: Any = importlib.import_module("matplotlib.pyplot")
        except ImportError as error:
            raise ImportError("plot needs Matplotlib: pip install beespace[plot]") from error
        return pyplot.figure().add_subplot(projection=projection)
    if projection is not None and ax.name != "3d":
        raise invalid('these axes are flat: make them with projection="3d"', "ax")
    return ax


class _Canvas:
    """Axes of two or three dimensions."""

    def __init__(self, ax: Any) -> None:
        self.ax = ax
        self.depth = 3 if ax.name == "3d" else 2

    def dots(self, places: NDArray[Any], color: str, label: str, marker: str = "o") -> None:
        many = len(places) > _many
        self.ax.scatter(
            *places[:, : self.depth].T,
            s=1 if many else 14,
            c=color,
            marker=marker,
            linewidths=1 if marker == "x" else 0,
            zorder=3,
            rasterized=many,
            label=label,
        )

    def lines(self, begins: NDArray[Any], ends: NDArray[Any], count: int) -> None:
        label = plural(count, "pair")
        drawn = count <= _most_lines
        if not drawn:
            begins, ends, label = begins[:0], ends[:0], f"{label}, too many to draw"
        segments = np.stack([begins, ends], axis=1)[:, :, : self.depth]
        if self.depth == 3:
            lines: Any = importlib.import_module("mpl_toolkits.mplot3d.art3d").Line3DCollection
        else:
            lines = importlib.import_module("matplotlib.collections").LineCollection
        collection = lines(segments, colors=_danger, linewidths=1.5, zorder=2, label=label)
        self.ax.add_collection(collection)

    def finish(self, first: _Drawn, second: _Drawn | None) -> None:
        ax = self.ax
        names = ("longitude [°]", "latitude [°]", "height [m]") if first.degrees else (
            "x [m]", "y [m]", "z [m]"
        )
        ax.set_xlabel(names[0])
        ax.set_ylabel(names[1])
        places = first.places if second is None else np.concatenate([first.places, second.places])
        if self.depth == 3:
            ax.set_zlabel(names[2])
            if len(places):
                # Of lines alone Matplotlib shows the origin, too.
                lows, highs = places.min(axis=0), places.max(axis=0)
                rims = np.where(highs > lows, (highs - lows) / 20, 1e-3 if first.degrees else 1.0)
                ax.set(**{
                    f"{axis}lim": (low, high)
                    for axis, low, high in zip("xyz", lows - rims, highs + rims)
                })
        if not first.degrees:
            ax.set_aspect("equal", **({} if self.depth == 3 else {"adjustable": "datalim"}))
        elif self.depth == 2 and len(places):
            middle = np.radians((places[:, 1].min() + places[:, 1].max()) / 2)
            ax.set_aspect(1 / max(float(np.cos(middle)), 0.01), adjustable="datalim")
        # Above the axes, where it hides no point.
        ax.legend(
            loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=4, frameon=False, handlelength=1.2,
            columnspacing=1.2, markerscale=4 if len(places) > _many else 1,
        )
