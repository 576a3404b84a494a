"""The search for the best level of scripts/isosurface.py."""

COARSE_STEPS = 6  # of the interval; halved until a step is 1/96 of it
HALVINGS = 4


def best_level(distance_of, low, high):
    """Of a coarse row of levels the best one, then, from it, of ever closer neighbours."""
    step = (high - low) / COARSE_STEPS
    distances = {level: distance_of(level) for level in (low + step * index for index in range(COARSE_STEPS + 1))}
    for _ in range(HALVINGS):
        step /= 2
        best = min(distances, key=distances.get)
        for level in (max(low, best - step), min(high, best + step)):
            distances[level] = distance_of(level)
    return min(distances, key=distances.get)
