"""Tells the installed package where RoboNewbie's own folder is, so that it finds the simulator from anywhere."""

from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py


class BuildWithLocation(build_py):
    def run(self):
        super().run()
        if not getattr(self, "editable_mode", False):
            home = Path(__file__).resolve().parent.parent
            Path(self.build_lib, "robonewbie", "home.txt").write_text(str(home), encoding="utf-8")


setup(cmdclass={"build_py": BuildWithLocation})
