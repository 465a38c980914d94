package org.robonewbie.competition.contest;

import java.util.Map;
import java.util.TreeMap;
import org.robonewbie.simulator.WorldSnapshot;

/** Judge that counts the goals in a match and ends the match when a team has no robots left. */
final class MatchJudge implements Judge {

    private final Map<String, Double> goals = new TreeMap<>();

    MatchJudge(ContestTrial trial) {
        trial.entrants().forEach(entrant -> goals.put(entrant.team(), 0.0));
    }

    @Override
    public boolean watch(WorldSnapshot world) {
        goals.replaceAll((team, before) -> Judge.isPresent(world, team) ? Judge.goals(world, team) : before);
        return !goals.keySet().stream().allMatch(team -> Judge.isPresent(world, team));
    }

    @Override
    public Map<String, Double> figures(String team) {
        return Map.of(GOALS, goals.getOrDefault(team, 0.0));
    }
}
