package org.robonewbie.protocol.effector;

import java.util.List;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.JoinTeam;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorCommand.Synchronise;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpWriter;

/**
 * Formats the commands of an agent. Numbers have up to nine decimal places and no exponent, a format that all servers
 * accept. The writer does not allocate memory.
 *
 * <pre>{@code
 * new EffectorMessageWriter(buffer).hingeSpeed("he1", 0.5).synchronise();
 * }</pre>
 */
public final class EffectorMessageWriter {

    /** The command that {@link #synchronise} writes. */
    public static final String SYNCHRONISE = "(syn)";

    private static final int DECIMALS = 9;

    private final SexpWriter writer;

    /**
     * Creates a writer.
     *
     * @param message the buffer to which the commands are appended
     */
    public EffectorMessageWriter(MessageBuffer message) {
        writer = new SexpWriter(message);
    }

    /**
     * Rounds a number to the precision used in commands.
     *
     * @param value the number to send
     * @return the number that the simulator receives
     */
    public static double rounded(double value) {
        return SexpWriter.rounded(value, DECIMALS);
    }

    /**
     * Writes a command of any type.
     *
     * @param command the command
     * @return this writer
     * @throws IllegalArgumentException if an argument of the command is invalid
     */
    public EffectorMessageWriter write(EffectorCommand command) {
        if (command instanceof SetHingeSpeed hinge) {
            return hingeSpeed(hinge.effectorName(), hinge.radiansPerSecond());
        } else if (command instanceof CreateRobot create) {
            return createRobot(create.path(), create.parameters());
        } else if (command instanceof JoinTeam join) {
            return joinTeam(join.number(), join.team());
        } else if (command instanceof Beam beam) {
            return beam(beam.pose());
        } else if (command instanceof Say say) {
            return say(say.text());
        }
        return command instanceof Synchronise ? synchronise() : requestPass();
    }

    /**
     * Writes the command that creates the robot.
     *
     * @param path scene file that describes the robot
     * @param parameters further arguments, such as the robot type
     * @return this writer
     * @throws IllegalArgumentException if an argument contains spaces, parentheses, semicolons or quotation marks
     */
    public EffectorMessageWriter createRobot(String path, List<String> parameters) {
        checkWord("Scene file", path);
        parameters.forEach(parameter -> checkWord("Scene parameter", parameter));
        writer.text("(scene ").text(path);
        for (String parameter : parameters) {
            writer.text(" ").text(parameter);
        }
        writer.text(")");
        return this;
    }

    /**
     * Writes the command that joins a team.
     *
     * @param number requested shirt number, 1 to 11, or 0 to let the simulator choose
     * @param team name of the team
     * @return this writer
     * @throws IllegalArgumentException if the name contains spaces, parentheses, semicolons or quotation marks
     */
    public EffectorMessageWriter joinTeam(int number, String team) {
        checkWord("Team name", team);
        writer.text("(init (unum ").integer(number);
        writer.text(")(teamname ").text(team).text("))");
        return this;
    }

    /**
     * Writes the command that places the robot at a pose in its own half.
     *
     * @param pose pose in the team's frame, in which its own half has negative x
     * @return this writer
     * @throws IllegalArgumentException if a coordinate or the heading is not finite
     */
    public EffectorMessageWriter beam(Pose2d pose) {
        checkNumber("Beam ", "x", pose.x());
        checkNumber("Beam ", "y", pose.y());
        checkNumber("Beam ", "heading", pose.degrees());
        writer.text("(beam ").decimal(pose.x(), DECIMALS);
        writer.text(" ").decimal(pose.y(), DECIMALS);
        writer.text(" ").decimal(pose.degrees(), DECIMALS);
        writer.text(")");
        return this;
    }

    /**
     * Writes the command that sets the speed of a motor.
     *
     * @param effectorName name of the motor, such as {@code he1}
     * @param radiansPerSecond speed in radians per second
     * @return this writer
     * @throws IllegalArgumentException if the speed is not finite
     */
    public EffectorMessageWriter hingeSpeed(String effectorName, double radiansPerSecond) {
        checkNumber("Speed of ", effectorName, radiansPerSecond);
        writer.text("(").text(effectorName).text(" ");
        writer.decimal(radiansPerSecond, DECIMALS).text(")");
        return this;
    }

    /**
     * Writes the command that shouts a short message to the other robots.
     *
     * @param text 1 to 20 printable ASCII characters other than parentheses, semicolons and quotation marks
     * @return this writer
     * @throws IllegalArgumentException if the text is empty, too long or contains a forbidden character
     */
    public EffectorMessageWriter say(String text) {
        checkWord("Text to say", new Say(text).text());
        writer.text("(say ").text(text).text(")");
        return this;
    }

    /**
     * Writes the command that requests pass mode.
     *
     * @return this writer
     */
    public EffectorMessageWriter requestPass() {
        writer.text("(pass)");
        return this;
    }

    /**
     * Writes the command that marks the end of the commands for this cycle.
     *
     * @return this writer
     */
    public EffectorMessageWriter synchronise() {
        writer.text(SYNCHRONISE);
        return this;
    }

    private static void checkNumber(String what, String name, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(
                    what + name + " is " + value + ", not a finite number. Was something divided by zero?");
        }
    }

    static void checkWord(String what, String word) {
        if (word.isEmpty()) {
            throw new IllegalArgumentException(what + " is empty. Use at least one character.");
        }
        for (int i = 0; i < word.length(); i++) {
            char character = word.charAt(i);
            if (character <= ' ' || character > '~' || "();\"'".indexOf(character) >= 0) {
                throw new IllegalArgumentException(what + " \"" + word + "\" cannot be sent because of the character '"
                        + character + "'. Use ASCII letters, digits and punctuation, without spaces, parentheses,"
                        + " semicolons or quotation marks.");
            }
        }
    }
}
