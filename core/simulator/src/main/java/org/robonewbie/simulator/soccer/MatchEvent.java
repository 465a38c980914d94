package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.monitor.FoulType;

/** Something that happened in the game within one cycle. */
public sealed interface MatchEvent {

    /**
     * Writes the event for a recording.
     *
     * @return its kind in one word and what belongs to it, such as {@code goal left Stars}
     */
    String text();

    /**
     * The referee decided something.
     *
     * @param playMode the new play mode
     */
    record PlayModeChanged(PlayMode playMode) implements MatchEvent {

        @Override
        public String text() {
            return "playmode " + playMode.simSparkName();
        }
    }

    /**
     * A goal that counts.
     *
     * @param side the team that scored
     * @param team the name of that team
     */
    record GoalScored(TeamSide side, String team) implements MatchEvent {

        @Override
        public String text() {
            return "goal " + (side == TeamSide.LEFT ? "left " : "right ") + team;
        }
    }

    /**
     * The referee has seen a foul.
     *
     * @param foul its kind
     * @param side the team of the robot
     * @param number the robot's number
     */
    record FoulCalled(FoulType foul, TeamSide side, int number) implements MatchEvent {

        @Override
        public String text() {
            return "foul " + foul + (side == TeamSide.LEFT ? " left " : " right ") + number;
        }
    }
}
