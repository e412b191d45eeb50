"""Other readings of a function of the formulas, derived from the right one."""


def given(**changes):
    """The function with other arguments, each made of all of them."""
    return lambda f: lambda *a, **k: f(*a, **k | {name: make(k) for name, make in changes.items()})


def times(factor):
    return lambda f: lambda *a, **k: factor * f(*a, **k)
