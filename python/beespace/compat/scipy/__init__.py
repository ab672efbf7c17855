"""`scipy.spatial.KDTree` and `cKDTree`, run by beespace.

An import line is all that changes:

>>> from beespace.compat.scipy import KDTree  # was: from scipy.spatial import KDTree
>>> tree = KDTree([[0.0, 0.0], [3.0, 4.0], [6.0, 9.0]])
>>> distance, id = tree.query([3.0, 3.0])
>>> print(distance, id)
1.0 1
>>> sorted(tree.query_pairs(6))
[(0, 1), (1, 2)]

What beespace does not do is handed over to the SciPy that is installed, which answers as ever: points
that do not have two or three coordinates, another norm than ``p=2``, ``eps`` other than 0, a
``boxsize``, ``weights``, and what SciPy refuses, so that errors are SciPy's own. `handed_over` and
`answered` count:

>>> KDTree.handed_over.clear()
>>> sorted(tree.query_pairs(6, p=1))
[]
>>> KDTree.handed_over
Counter({('query_pairs', 'p is not 2'): 1})

Where answers differ
--------------------
Whether two points are within r is decided of the real numbers that the coordinates and r are. SciPy
rounds the differences, their squares, the sum and r * r, and takes whole branches of its tree by
rounded bounds. So of pairs whose distance is r but for the last digits, SciPy may count those that are
farther than r, and leave out those that are not; here none is wrong. Distances are the same to the
last bit where SciPy was compiled without fused multiplications (x86-64). Points that are equally far
come in the order of their indices, where SciPy promises no order. `query` leaves out neighbours whose
distance, as it is returned, is not below `distance_upper_bound`.
"""

from beespace.compat.scipy._handing import answered, handed_over
from beespace.compat.scipy._trees import KDTree, cKDTree

__all__ = ["KDTree", "answered", "cKDTree", "handed_over"]
