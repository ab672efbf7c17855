"""What other packages offer, under their names and with their arguments, run by beespace.

`beespace.compat.scipy` has the k-d trees of SciPy. Nothing here is imported by `import beespace`.
"""
