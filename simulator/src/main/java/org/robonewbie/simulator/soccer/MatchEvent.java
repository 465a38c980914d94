package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;

/** Something that happened in the game within one cycle. */
public sealed interface MatchEvent {

    /**
     * The referee decided something.
     *
     * @param playMode the new play mode
     */
    record PlayModeChanged(PlayMode playMode) implements MatchEvent {}

    /**
     * A goal that counts.
     *
     * @param side the team that scored
     * @param team the name of that team
     */
    record GoalScored(TeamSide side, String team) implements MatchEvent {}
}
