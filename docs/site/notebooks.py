"""Which notebooks the site shows as they are written, since what they need is not there: others run them."""

from __future__ import annotations

# Spark; python/spark_tests/test_notebook.py runs it.
NOT_RUN = ("docs/notebooks/flights-on-a-cluster.ipynb",)
