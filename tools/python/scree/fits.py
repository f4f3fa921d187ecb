"""Means with errors and fits, and loops of cyclic loads, as arrays of numpy."""
import math
import statistics

from .errors import package


def mean_and_error(values):
    """Mean and standard error of the mean, which is nan for one value; both are nan where a value is."""
    values = [float(value) for value in values]
    if any(math.isnan(value) for value in values):
        return math.nan, math.nan
    error = statistics.stdev(values) / math.sqrt(len(values)) if len(values) > 1 else math.nan
    return statistics.fmean(values), error


def line_through(values):
    """Slope per value, and root mean square deviation, of the straight line through values by least squares."""
    numpy = package("numpy")
    places = numpy.arange(len(values)) - (len(values) - 1) / 2
    about_mean = numpy.asarray(values) - numpy.mean(values)
    slope = (places @ about_mean) / (places @ places)
    return slope, numpy.sqrt(numpy.mean((about_mean - slope * places) ** 2))


def proportional(x, y):
    """A and R² of y = A x by least squares; R² is nan where all y are the same."""
    numpy = package("numpy")
    x, y = numpy.asarray(x), numpy.asarray(y)
    slope = (y @ x) / (x @ x)
    spread = ((y - y.mean()) ** 2).sum()
    return slope, 1 - ((y - slope * x) ** 2).sum() / spread if spread > 0 else math.nan


def power(x, y):
    """Exponent n of y ∝ x^n by least squares of the logarithms."""
    return statistics.linear_regression(list(map(math.log, x)), list(map(math.log, y))).slope


def maximum(x, y):
    """x and y of the largest y, by a parabola through it and its neighbours at equal distances of x."""
    k = min(max(int(y.argmax()), 1), len(y) - 2)
    low, middle, high = y[k - 1 : k + 2]
    bend = low - 2 * middle + high
    shift = 0.5 * (low - high) / bend if bend < 0 else 0.0
    return x[k] + shift * (x[k + 1] - x[k]), middle - 0.25 * (low - high) * shift


def cycles_of(values, length):
    """The whole cycles of values: each has length + 1, of which the last is the first of the next."""
    return [values[at : at + length + 1] for at in range(0, len(values) - length, length)]


def loop_area(x, y):
    """∮ y dx of a loop, closed from its last point to its first, as `scree cycles` has it."""
    roll = package("numpy").roll
    return ((y + roll(y, -1)) / 2 * (roll(x, -1) - x)).sum()


def loop_slope(x, y):
    """Slope from the first point of a loop to its largest y."""
    top = y.argmax()
    return (y[top] - y[0]) / (x[top] - x[0])
