package org.robonewbie.protocol.effector;

import java.util.List;
import org.robonewbie.nao.geometry.Pose2d;

/** A command from an agent to the simulator. */
public sealed interface EffectorCommand {

    /**
     * Creates the robot: {@code (scene rsg/agent/nao/nao_hetero.rsg 0)}. Each agent sends this command first.
     *
     * @param path scene file that describes the robot
     * @param parameters further arguments, such as the robot type
     */
    record CreateRobot(String path, List<String> parameters) implements EffectorCommand {

        /** The scene file of robot type 0. */
        public static final String SCENE = "rsg/agent/nao/nao.rsg";

        /** The scene file with the robot type as its parameter. */
        public static final String SCENE_OF_TYPE = "rsg/agent/nao/nao_hetero.rsg";

        /** Stores an unmodifiable copy of the list. */
        public CreateRobot {
            parameters = List.copyOf(parameters);
        }

        /**
         * Returns the command that creates a robot of the given type.
         *
         * @param type the robot type, 0 to 4
         * @return the command
         */
        public static CreateRobot of(int type) {
            return type == 0
                    ? new CreateRobot(SCENE, List.of())
                    : new CreateRobot(SCENE_OF_TYPE, List.of(Integer.toString(type)));
        }
    }

    /**
     * Joins a team: {@code (init (unum 1)(teamname Stars))}.
     *
     * @param number requested shirt number, 1 to 11, or 0 to let the simulator choose
     * @param team name of the team; empty if the message contains none
     */
    record JoinTeam(int number, String team) implements EffectorCommand {}

    /**
     * Places the robot at a pose in its own half before a kick-off: {@code (beam -1 0.5 90)}.
     *
     * @param pose pose in the team's frame, in which its own half has negative x
     */
    record Beam(Pose2d pose) implements EffectorCommand {

        /** {@return the command in the format used in recordings} */
        @Override
        public String toString() {
            return "Beam[xMetres=" + pose.x() + ", yMetres=" + pose.y() + ", headingDegrees=" + pose.degrees() + "]";
        }
    }

    /**
     * Sets the speed of a motor: {@code (he1 0.5)}. The motor keeps this speed until the next command. This is the only command
     * that uses radians, as SimSpark requires.
     *
     * @param effectorName the motor's name in SimSpark's messages
     * @param radiansPerSecond speed in radians per second
     */
    record SetHingeSpeed(String effectorName, double radiansPerSecond) implements EffectorCommand {}

    /**
     * Shouts a short message to the other robots: {@code (say hello)}.
     *
     * @param text 1 to 20 printable ASCII characters other than parentheses
     */
    record Say(String text) implements EffectorCommand {

        /** The maximum length of the text in characters. */
        public static final int MAX_LENGTH = 20;

        /**
         * Checks the text.
         *
         * @throws IllegalArgumentException if the text is empty, too long or contains a forbidden character
         */
        public Say {
            if (text.isEmpty()) {
                throw new IllegalArgumentException("A robot cannot say an empty text. Use 1 to 20 characters.");
            }
            if (text.length() > MAX_LENGTH) {
                throw new IllegalArgumentException("A robot can say at most 20 characters, but \"" + text + "\" has "
                        + text.length() + ". Make it shorter.");
            }
            for (int i = 0; i < text.length(); i++) {
                char character = text.charAt(i);
                if (character <= ' ' || character > '~' || character == '(' || character == ')') {
                    throw new IllegalArgumentException(
                            "A robot cannot say \"" + text + "\" because of the character '" + character
                                    + "'. Use ASCII letters, digits and punctuation, without spaces or parentheses.");
                }
            }
        }
    }

    /** Requests pass mode, in which opponents must keep away from the ball: {@code (pass)}. */
    record RequestPass() implements EffectorCommand {}

    /** Marks the end of the agent's commands for this cycle: {@code (syn)}. */
    record Synchronise() implements EffectorCommand {}
}
