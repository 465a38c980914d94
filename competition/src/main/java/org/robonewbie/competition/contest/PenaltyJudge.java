package org.robonewbie.competition.contest;

import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.SimulationControl;

/** Sees whether the attacker scores before its time is over, the ball is out, or it has left the pitch. */
final class PenaltyJudge implements Judge {

    static final String GOALS = "goals";

    private final String attacker;
    private double goals;

    PenaltyJudge(ContestTrial trial) {
        this.attacker = trial.entrants().get(0).team();
    }

    @Override
    public boolean watch(JudgedMoment moment, SimulationControl referee) {
        Optional<TeamSide> side = moment.side(attacker);
        if (side.isEmpty()) {
            return true;
        }
        goals = Math.min(1, moment.goals(side.get()));
        return switch (moment.world().playMode()) {
            case PLAY_ON, KICK_OFF_LEFT, KICK_OFF_RIGHT -> goals > 0;
            default -> true;
        };
    }

    @Override
    public Map<String, Double> figures(String team) {
        return team.equals(attacker) ? Map.of(GOALS, goals) : Map.of();
    }
}
