package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.monitor.FoulType;

/** Event of a match. */
public sealed interface MatchEvent {

    /**
     * Returns the event as text for a recording.
     *
     * @return the kind of the event in one word and its details, such as {@code goal left Stars}
     */
    String text();

    /**
     * The play mode has changed.
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
     * A goal has been scored.
     *
     * @param side side of the team that scored
     * @param team name of that team
     */
    record GoalScored(TeamSide side, String team) implements MatchEvent {

        @Override
        public String text() {
            return "goal " + (side == TeamSide.LEFT ? "left " : "right ") + team;
        }
    }

    /**
     * A foul has been called.
     *
     * @param foul type of the foul
     * @param side side of the player's team
     * @param number shirt number of the player
     */
    record FoulCalled(FoulType foul, TeamSide side, int number) implements MatchEvent {

        @Override
        public String text() {
            return "foul " + foul + (side == TeamSide.LEFT ? " left " : " right ") + number;
        }
    }
}
