package org.robonewbie.protocol.effector;

import java.util.List;
import org.robonewbie.nao.Joint;
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
 * Writes an agent's commands. Numbers are plain decimals, never with an exponent, so that every server understands them; nine
 * decimals of a speed are exact to a billionth of a radian. Writing does not allocate.
 *
 * <pre>{@code
 * new EffectorMessageWriter(buffer).hingeSpeed(Joint.NECK_YAW, 0.5).synchronise();
 * }</pre>
 */
public final class EffectorMessageWriter {

    /** The command that ends the commands of a cycle, as {@link #synchronise} writes it. */
    public static final String SYNCHRONISE = "(syn)";

    private static final int DECIMALS = 9;

    private final SexpWriter writer;

    /**
     * Creates a writer.
     *
     * @param message the buffer at whose end the commands are written
     */
    public EffectorMessageWriter(MessageBuffer message) {
        writer = new SexpWriter(message);
    }

    /**
     * Rounds a number as messages to a simulator do.
     *
     * @param value a number of a command
     * @return the number that the simulator reads
     */
    public static double rounded(double value) {
        return SexpWriter.rounded(value, DECIMALS);
    }

    /**
     * Writes any command.
     *
     * @param command the command
     * @return this writer
     * @throws IllegalArgumentException if a word or number of the command cannot be sent
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
     * Writes the command that builds the robot.
     *
     * @param path the scene file that describes the robot
     * @param parameters further words, such as the number of the robot type
     * @return this writer
     * @throws IllegalArgumentException if a word contains blanks, parentheses or quotation marks
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
     * @param number the wanted shirt number, 1 to 11; 0 leaves the choice to the simulator
     * @param team the team's name
     * @return this writer
     * @throws IllegalArgumentException if the name contains blanks, parentheses or quotation marks
     */
    public EffectorMessageWriter joinTeam(int number, String team) {
        checkWord("Team name", team);
        writer.text("(init (unum ").integer(number);
        writer.text(")(teamname ").text(team).text("))");
        return this;
    }

    /**
     * Writes the command that places the robot on its own half.
     *
     * @param pose in the coordinates of the team; the own half has negative x
     * @return this writer
     * @throws IllegalArgumentException if a number is not finite
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
     * Writes the command that sets the speed of a joint's motor.
     *
     * @param joint the joint
     * @param radiansPerSecond the speed
     * @return this writer
     * @throws IllegalArgumentException if the speed is not finite
     */
    public EffectorMessageWriter hingeSpeed(Joint joint, double radiansPerSecond) {
        return hingeSpeed(joint.effectorName(), radiansPerSecond);
    }

    /**
     * Writes the command that sets the speed of a hinge's motor.
     *
     * @param effectorName the motor's name, such as {@code lle7} for the left toe
     * @param radiansPerSecond the speed
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
     * Writes the command that shouts a text across the field.
     *
     * @param text 1 to 20 ASCII characters without blanks, parentheses, semicolon and quotation marks
     * @return this writer
     * @throws IllegalArgumentException if a simulator would not transmit the text
     */
    public EffectorMessageWriter say(String text) {
        checkWord("Text to say", new Say(text).text());
        writer.text("(say ").text(text).text(")");
        return this;
    }

    /**
     * Writes the command that asks the referee for pass mode.
     *
     * @return this writer
     */
    public EffectorMessageWriter requestPass() {
        writer.text("(pass)");
        return this;
    }

    /**
     * Writes the command that ends the commands of this cycle.
     *
     * @return this writer
     */
    public EffectorMessageWriter synchronise() {
        writer.text(SYNCHRONISE);
        return this;
    }

    private static void checkNumber(String what, String name, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(what + name + " is " + value
                    + ", which is no number that a robot can use. Was" + " something divided by zero?");
        }
    }

    private static void checkWord(String what, String word) {
        if (word.isEmpty()) {
            throw new IllegalArgumentException(what + " is empty. Give it at least one character.");
        }
        for (int i = 0; i < word.length(); i++) {
            char character = word.charAt(i);
            if (character <= ' ' || character > '~' || "();\"'".indexOf(character) >= 0) {
                throw new IllegalArgumentException(what + " \"" + word + "\" cannot be sent because of the character '"
                        + character + "'. Use letters, digits and signs of ASCII without blanks, parentheses,"
                        + " semicolons and quotation marks.");
            }
        }
    }
}
