"""Paths of drawings by the rules of SVG."""

import re

import numpy as np

COMMAND = re.compile(r"([MlhvLz])([^MlhvLz]*)")
NUMBER = re.compile(r"-?(?:\d+\.?\d*|\.\d+)")
TAKES = {"M": 2, "l": 2, "h": 1, "v": 1, "z": 0}


def walked(path: str) -> list[list[tuple[int, int]]]:
    """Points of each piece in tenths of a pixel, by the rules of SVG for M, l, h, v and z."""
    pieces, x, y = [], 0, 0
    for name, coordinates in COMMAND.findall(path):
        numbers = [round(10 * float(n)) for n in NUMBER.findall(coordinates)]
        if name == "z":
            continue
        assert len(numbers) % TAKES[name] == 0
        for i in range(0, len(numbers), TAKES[name]):
            dx, dy = {"h": (numbers[i], 0), "v": (0, numbers[i])}.get(name, numbers[i : i + 2])
            if name == "M":
                x, y = dx, dy
                pieces.append([])
            else:
                x, y = x + dx, y + dy
            pieces[-1].append((x, y))
    return pieces


def corners(drawing: object, css: str) -> list[np.ndarray]:
    """Points (n, 2) of every path of these classes, as drawings have them before they are slim."""
    found = re.findall(rf'class="{css}" d="M([^"z]*)', str(drawing))
    return [np.array([p.split(",") for p in path.split("L")], float) for path in found]
