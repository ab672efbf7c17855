"""Arrays that have units, as those of other libraries, and say so in as many ways."""

from __future__ import annotations

import numpy as np


class Astropy(np.ndarray):
    """As a quantity of astropy: an array with a unit, which NumPy drops."""

    unit = "km"

    def to_value(self, unit):
        raise NotImplementedError

    def __float__(self):
        raise TypeError("only what has no unit is a number")


class Pint:
    """As a quantity of pint."""

    def __init__(self, magnitude, units):
        self.magnitude = magnitude
        self.units = units
        self.shape = magnitude.shape
        self.ndim = magnitude.ndim

    def m_as(self, unit):
        raise NotImplementedError

    def __len__(self):
        return len(self.magnitude)

    def __array__(self, dtype=None, copy=None):
        raise AssertionError("the unit would be lost")


class Unyt(np.ndarray):
    """As a quantity of unyt: also a single one is an array, and a number for those who ask."""

    units = "km"

    def to_value(self, unit):
        raise NotImplementedError


class Xarray:
    """As an array of xarray, of any dimensions."""

    def __init__(self, numbers, units):
        self.numbers = np.asarray(numbers, np.float64)
        self.attrs = {"units": units}
        self.dtype, self.shape, self.ndim = self.numbers.dtype, self.numbers.shape, self.numbers.ndim

    def __len__(self):
        return len(self.numbers)

    def __getitem__(self, index):
        return Xarray(self.numbers[index], self.attrs["units"])

    def __float__(self):
        return float(self.numbers)

    def __array__(self, dtype=None, copy=None):
        return self.numbers


def in_kilometres(numbers):
    """The numbers, as each of the libraries says that they are in kilometres."""
    array = np.asarray(numbers, np.float64)
    return [array.view(Astropy), array.view(Unyt), Pint(array, "kilometer"), Xarray(array, "km")]
