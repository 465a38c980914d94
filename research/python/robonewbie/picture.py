"""Software renderer for an environment: draws a box for each limb of a robot, the ball, and the ground."""

import numpy as np

WIDTH, HEIGHT = 480, 360
_FACES = np.array([[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]])
_SUN = np.array([-0.35, -0.5, 0.8]) / np.linalg.norm([-0.35, -0.5, 0.8])
_SKY, _GRASS, _LINE, _BALL = (196, 220, 240), (72, 128, 64), (110, 160, 100), (250, 250, 245)
_LIMB = np.array([225, 228, 232])
_SHIRTS = [(214, 110, 60), (70, 120, 200)]
_NEAR = 0.1


class _Camera:
    """Perspective camera behind and to the right of the first robot."""

    def __init__(self, target):
        self.position = target + np.array([-1.1, -1.7, 0.75])
        ahead = target - self.position
        self.ahead = ahead / np.linalg.norm(ahead)
        self.right = np.cross(self.ahead, [0, 0, 1])
        self.right /= np.linalg.norm(self.right)
        self.up = np.cross(self.right, self.ahead)
        self.scale = 1.9 * HEIGHT

    def project(self, points):
        """Projects points, given in metres; returns their pixel coordinates and depths."""
        relative = np.asarray(points, dtype=float) - self.position
        depth = np.maximum(relative @ self.ahead, 1e-9)
        x = WIDTH / 2 + self.scale * (relative @ self.right) / depth
        y = HEIGHT / 2 - self.scale * (relative @ self.up) / depth
        return np.stack([x, y], axis=-1), depth


def _fill(image, corners, colour):
    """Fills a convex polygon."""
    low = np.maximum(np.floor(corners.min(axis=0)).astype(int), 0)
    high = np.minimum(np.ceil(corners.max(axis=0)).astype(int) + 1, [WIDTH, HEIGHT])
    if (low >= high).any():
        return
    x, y = np.meshgrid(np.arange(low[0], high[0]) + 0.5, np.arange(low[1], high[1]) + 0.5)
    following = np.roll(corners, -1, axis=0)
    sides = [
        (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) for a, b in zip(corners, following)
    ]
    inside = (np.min(sides, axis=0) >= 0) | (np.max(sides, axis=0) <= 0)
    image[low[1] : high[1], low[0] : high[0]][inside] = colour


def _ground(camera):
    """Renders the ground with lines every half metre, and the sky above the horizon."""
    x, y = np.meshgrid(np.arange(WIDTH) + 0.5 - WIDTH / 2, HEIGHT / 2 - np.arange(HEIGHT) - 0.5)
    rays = camera.ahead + (x[..., None] * camera.right + y[..., None] * camera.up) / camera.scale
    downwards = rays[..., 2] < -1e-6
    distance = np.where(downwards, camera.position[2] / -np.where(downwards, rays[..., 2], -1), 0)
    hit = camera.position[:2] + distance[..., None] * rays[..., :2]
    line = (np.abs(hit * 2 - np.round(hit * 2)) < 0.02).any(axis=-1) & (distance < 8)
    image = np.empty((HEIGHT, WIDTH, 3), dtype=np.uint8)
    image[:] = _SKY
    image[downwards] = _GRASS
    image[downwards & line] = _LINE
    return image


def _faces(robots, camera):
    for number, robot in enumerate(robots):
        shirt = np.array(_SHIRTS[number % 2])
        for part, box in enumerate(np.asarray(robot)):
            centre = box.mean(axis=0)
            colour = shirt if part == 0 else _LIMB
            for face in _FACES:
                corners = box[face]
                normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
                normal *= np.sign(normal @ (corners.mean(axis=0) - centre)) / np.linalg.norm(normal)
                if normal @ (camera.position - corners[0]) > 0:
                    light = 0.55 + 0.45 * max(0, normal @ _SUN)
                    yield corners, light * colour


def draw(moment):
    """Renders the simulator's description of a moment as an array of HEIGHT x WIDTH x 3 bytes."""
    camera = _Camera(np.asarray(moment["robots"][0]).mean(axis=(0, 1)))
    image = _ground(camera)
    shapes = []
    for corners, colour in _faces(moment["robots"], camera):
        pixels, depth = camera.project(corners)
        if depth.min() > _NEAR:
            shapes.append((depth.mean(), pixels, colour))
    ball, depth = camera.project(moment["ball"])
    if depth > _NEAR:
        angle = np.linspace(0, 2 * np.pi, 16, endpoint=False)
        circle = ball + camera.scale * 0.042 / depth * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        shapes.append((depth, circle, _BALL))
    for _, pixels, colour in sorted(shapes, key=lambda shape: -shape[0]):
        _fill(image, pixels, colour)
    return image
