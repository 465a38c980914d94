"""The robot as models for MuJoCo."""

from pathlib import Path

_FOLDER = Path(__file__).with_name("models")


def model_path(name="nao0"):
    """Returns the path of the MJCF file of a robot type, for ``mujoco.MjModel.from_xml_path``.

    The robot stands on the ground. Its motors take speeds in radians per second; ``robonewbie export --mjcf`` writes models with other
    motors and with a pitch.

    :param name: ``nao0`` for the standard robot, up to ``nao4``
    :raises ValueError: if there is no such robot
    """
    file = _FOLDER / f"{name}.xml"
    names = sorted(each.stem for each in _FOLDER.glob("*.xml"))
    if name not in names:
        raise ValueError(f"There is no robot {name!r}. Choose one of {', '.join(names)}.")
    return str(file)
