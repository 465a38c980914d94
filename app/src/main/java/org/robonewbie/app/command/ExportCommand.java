package org.robonewbie.app.command;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.UnwritableFileException;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.robot.NaoRobot;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.simulator.export.ExportedScene;
import org.robonewbie.simulator.export.MjcfFile;
import org.robonewbie.simulator.export.MotorKind;
import org.robonewbie.simulator.export.UrdfFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code robonewbie export}: writes the robot for other simulators. */
@Command(
        name = "export",
        description = {
            "Write the simulated NAO for another simulator: as MJCF for MuJoCo, or as URDF.",
            "The files need no meshes. Bodies, joints and sensors equal those of the simulator."
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie export --mjcf nao.xml",
            "      then: python -m mujoco.viewer --mjcf=nao.xml",
            "  robonewbie export --mjcf nao.xml --motors position --scene pitch",
            "  robonewbie export --urdf nao.urdf --type 3"
        })
final class ExportCommand implements Callable<Integer> {

    private static final int MAX_TYPE = RobotType.values().length - 1;

    @Mixin
    final HelpOption help = new HelpOption();

    @Option(names = "--mjcf", paramLabel = "FILE", description = "Write this MJCF file.")
    private Optional<Path> mjcf = Optional.empty();

    @Option(names = "--urdf", paramLabel = "FILE", description = "Write this URDF file.")
    private Optional<Path> urdf = Optional.empty();

    @Option(names = "--type", paramLabel = "N", description = "Robot type, 0 to 4 (default: ${DEFAULT-VALUE}).")
    private int type;

    @Option(
            names = "--motors",
            paramLabel = "KIND",
            description = "What the motors are given: speed, position or torque (default: speed); MJCF only.")
    private Optional<MotorKind> motors = Optional.empty();

    @Option(
            names = "--scene",
            paramLabel = "NAME",
            description = "What surrounds the robot: plain (the ground) or pitch (the beginners' pitch with a ball)"
                    + " (default: plain); MJCF only.")
    private Optional<ExportedScene> scene = Optional.empty();

    @Override
    public Integer call() throws UnwritableFileException {
        if (mjcf.isEmpty() && urdf.isEmpty()) {
            throw new CalledWronglyException("Say what to write: --mjcf FILE, --urdf FILE or both.");
        }
        if (mjcf.isEmpty() && (motors.isPresent() || scene.isPresent())) {
            throw new CalledWronglyException("--motors and --scene belong to --mjcf FILE: a URDF file has neither.");
        }
        if (type < 0 || type > MAX_TYPE) {
            throw new CalledWronglyException("There is no robot type " + type + ". Choose 0 to " + MAX_TYPE + ".");
        }
        RobotModel robot = NaoRobot.of(RobotType.values()[type]);
        if (mjcf.isPresent()) {
            MotorKind kind = motors.orElse(MotorKind.SPEED);
            write(mjcf.get(), MjcfFile.of(robot, kind, scene.orElse(ExportedScene.PLAIN), head()));
        }
        if (urdf.isPresent()) {
            write(urdf.get(), UrdfFile.of(robot, head()));
        }
        return ExitCode.OK;
    }

    private String head() {
        return "The simulated NAO of SimSpark, robot type " + type + ", made by RoboNewbie " + ProgramVersion.number()
                + ".\nSource: the scene files of rcssserver3d 0.7.3. SPDX-License-Identifier: Apache-2.0";
    }

    private static void write(Path file, String text) throws UnwritableFileException {
        AtomicFile.write(file, text);
        System.out.println("Wrote " + file);
    }
}
