"""Order of convergence and extrapolation to spacing zero, from three spacings of any ratios."""


def richardson(spacings, values):
    """(order p, value at spacing 0) of f(d) = f0 + C d^p through the last three points, finest last; (None, None) if
    they are not monotonic or no order in 0.2...8 fits: then they are no asymptotic series, and nothing follows."""
    (d1, d2, d3), (f1, f2, f3) = spacings[-3:], values[-3:]
    if (f1 - f2) * (f2 - f3) <= 0:
        return None, None
    wanted = (f1 - f2) / (f2 - f3)

    def ratio(p):
        return (d1 ** p - d2 ** p) / (d2 ** p - d3 ** p)

    low, high = 0.2, 8.0
    if not ratio(low) <= wanted <= ratio(high):
        return None, None
    for _ in range(60):
        middle = 0.5 * (low + high)
        if ratio(middle) < wanted:
            low = middle
        else:
            high = middle
    p = 0.5 * (low + high)
    return p, f3 + (f3 - f2) * d3 ** p / (d2 ** p - d3 ** p)
