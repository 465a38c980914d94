package org.robonewbie.competition.contest;

import java.util.Map;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * Judge for a penalty kick. The attack ends when a goal is scored, when the ball is out, or when the attacker leaves
 * the pitch; pass mode does not end it.
 */
final class PenaltyJudge implements Judge {

    private final String attacker;
    private double goals;

    PenaltyJudge(ContestTrial trial) {
        this.attacker = trial.entrants().get(0).team();
    }

    @Override
    public boolean watch(WorldSnapshot world) {
        if (!Judge.isPresent(world, attacker)) {
            return true;
        }
        goals = Math.min(1, Judge.goals(world, attacker));
        return switch (world.playMode()) {
            case PLAY_ON, KICK_OFF_LEFT, KICK_OFF_RIGHT, PASS_LEFT, PASS_RIGHT -> goals > 0;
            default -> true;
        };
    }

    @Override
    public Map<String, Double> figures(String team) {
        return team.equals(attacker) ? Map.of(GOALS, goals) : Map.of();
    }
}
