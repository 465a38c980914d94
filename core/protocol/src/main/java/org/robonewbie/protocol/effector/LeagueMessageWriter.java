package org.robonewbie.protocol.effector;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpWriter;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * Formats the messages of an agent to RCSSServerMJ 0.2.1. One wrong message ends that server for all robots, or resets its world, so
 * this writer can only write motors of the robot's model, finite numbers, and numbers within the limits below.
 *
 * <pre>{@code
 * LeagueMessageWriter writer = new LeagueMessageWriter(buffer, BoosterT1.MODEL);
 * writer.motor(0, 20, 0, 40, 1.5, 0);   // turns the head to 20 degrees
 * }</pre>
 */
public final class LeagueMessageWriter {

    /** Largest stiffness in newton metres per radian. */
    public static final double MAX_STIFFNESS = 500;

    /** Largest damping in newton metres per radian per second. */
    public static final double MAX_DAMPING = 20;

    /** Largest target speed in degrees per second. */
    public static final double MAX_DEGREES_PER_SECOND = 1000;

    /** Longest text that the server passes on, in bytes. */
    public static final int MAX_SPOKEN_BYTES = 10;

    private static final double MAX_METRES = 100;
    private static final int DECIMALS = 3;

    private final SexpWriter writer;
    private final RobotModel model;

    /**
     * Creates a writer.
     *
     * @param message the buffer to which the messages are appended
     * @param model the robot
     */
    public LeagueMessageWriter(MessageBuffer message, RobotModel model) {
        this.writer = new SexpWriter(message);
        this.model = model;
    }

    /**
     * Writes the message with which a robot joins; it is the first message of each agent.
     *
     * @param team name of the team
     * @param number player number, 1 to 99
     * @throws IllegalArgumentException if the name is empty or contains spaces, parentheses, semicolons or quotation marks
     */
    public void join(String team, int number) {
        EffectorMessageWriter.checkWord("Team name", team);
        writer.text("(init ")
                .text(model.name())
                .text(" ")
                .text(team)
                .text(" ")
                .integer(number)
                .text(")");
    }

    /**
     * Writes the command that places the robot at a pose in its own half.
     *
     * @param pose pose in the team's frame; a number that is not finite counts as 0
     */
    public void beam(Pose2d pose) {
        writer.text("(beam ");
        number(limit(pose.x(), -MAX_METRES, MAX_METRES)).text(" ");
        number(limit(pose.y(), -MAX_METRES, MAX_METRES)).text(" ");
        number(limit(pose.degrees(), -360, 360)).text(")");
    }

    /**
     * Writes the command of a motor: torque = stiffness · (target − angle) + damping · (target speed − speed) + extra torque. Numbers
     * beyond their range are limited to it; a number that is not finite counts as 0.
     *
     * @param joint index of the joint in the robot's model
     * @param degrees target angle in degrees, limited to the joint's range
     * @param degreesPerSecond target speed, up to {@value #MAX_DEGREES_PER_SECOND}
     * @param stiffness 0 to {@value #MAX_STIFFNESS} newton metres per radian
     * @param damping 0 to {@value #MAX_DAMPING} newton metres per radian per second
     * @param newtonMetres extra torque, limited to that of the motor
     * @throws IndexOutOfBoundsException if the robot has no such joint
     */
    public void motor(
            int joint, double degrees, double degreesPerSecond, double stiffness, double damping, double newtonMetres) {
        RobotJoint moved = model.joints().get(joint);
        double strongest = moved.motor() instanceof Motor.Torque motor ? motor.maxNewtonMetres() : 0;
        writer.text("(").text(moved.effectorName()).text(" ");
        number(limit(degrees, moved.minDegrees(), moved.maxDegrees())).text(" ");
        number(limit(degreesPerSecond, -MAX_DEGREES_PER_SECOND, MAX_DEGREES_PER_SECOND))
                .text(" ");
        number(limit(stiffness, 0, MAX_STIFFNESS)).text(" ");
        number(limit(damping, 0, MAX_DAMPING)).text(" ");
        number(limit(newtonMetres, -strongest, strongest)).text(")");
    }

    /**
     * Writes the command that shouts a short message.
     *
     * @param text 1 to {@value #MAX_SPOKEN_BYTES} printable ASCII characters
     * @throws IllegalArgumentException if the text is empty or longer
     */
    public void say(String text) {
        byte[] bytes = new Say(text).text().getBytes(StandardCharsets.US_ASCII);
        if (bytes.length > MAX_SPOKEN_BYTES) {
            throw new IllegalArgumentException("A robot of this league can say at most " + MAX_SPOKEN_BYTES
                    + " characters, but \"" + text + "\" has " + bytes.length + ". Make it shorter.");
        }
        writer.text("(SPK say 100 ")
                .text(Base64.getEncoder().encodeToString(bytes))
                .text(")");
    }

    /** Writes the message of a cycle without commands. */
    public void nothing() {
        writer.text(EffectorMessageWriter.SYNCHRONISE);
    }

    private SexpWriter number(double value) {
        return writer.decimal(value, DECIMALS);
    }

    private static double limit(double value, double least, double most) {
        return Double.isFinite(value) ? Math.max(least, Math.min(most, value)) : Math.max(least, Math.min(most, 0));
    }
}
