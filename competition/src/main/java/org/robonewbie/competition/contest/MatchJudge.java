package org.robonewbie.competition.contest;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.SimulationControl;

/** Counts the goals of a match. It ends at once when a team has no robot left. */
final class MatchJudge implements Judge {

    static final String GOALS = "goals";

    private final ContestTrial trial;
    private final Map<String, Double> goals = new TreeMap<>();

    MatchJudge(ContestTrial trial) {
        this.trial = trial;
    }

    @Override
    public boolean watch(JudgedMoment moment, SimulationControl referee) {
        boolean anybodyMissing = false;
        for (Entrant entrant : trial.entrants()) {
            Optional<TeamSide> side = moment.side(entrant.team());
            side.ifPresent(own -> goals.put(entrant.team(), (double) moment.goals(own)));
            anybodyMissing |= side.isEmpty();
        }
        return anybodyMissing;
    }

    @Override
    public Map<String, Double> figures(String team) {
        return Map.of(GOALS, goals.getOrDefault(team, 0.0));
    }
}
