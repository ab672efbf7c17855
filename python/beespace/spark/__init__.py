"""Which of very many points are closer than a threshold, on a cluster of Apache Spark.

Data frames of Spark in and out. Space is cut into cells, each of which is searched, with the points
around it, by the engine of beespace; ids, pairs and distances are those of one machine, bit for bit.

A call checks its columns at once, and then looks at all rows in one pass (two where ids do not ascend):
what cannot be used is an error before the long work starts. The answer is lazy, as Spark's are. The data
frame must give the same rows each time.

Workers need this package: installed, or shipped with ``--archives``. PySpark 3.5 or 4 and pyarrow must be
installed; this module does not import them before a function is called.
"""

from __future__ import annotations

from beespace.spark._nearest import closest_pair, nearest
from beespace.spark._points import at_risk, counts, facts, pairs
from beespace.spark._recordings import conflicts, gaps
from beespace.spark._search import CutFacts

__all__ = [
    "CutFacts",
    "at_risk",
    "closest_pair",
    "conflicts",
    "counts",
    "facts",
    "gaps",
    "nearest",
    "pairs",
]
