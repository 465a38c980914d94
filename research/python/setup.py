"""Tells the installed package where RoboNewbie is: it includes the jar of a release, or else the path of this source tree."""

import os
import shutil
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py


class BuildWithProgram(build_py):
    def run(self):
        super().run()
        package = Path(self.build_lib, "robonewbie")
        jar = os.environ.get("ROBONEWBIE_JAR")
        if jar:
            shutil.copyfile(jar, package / "robonewbie.jar")
        elif not getattr(self, "editable_mode", False):
            home = Path(__file__).resolve().parents[2]
            (package / "home.txt").write_text(str(home), encoding="utf-8")


setup(cmdclass={"build_py": BuildWithProgram})
