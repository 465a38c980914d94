package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robonewbie.simulator.SimulationControl;

/** Measures a race towards the opponents' goal: the distance covered, and when the line is crossed upright. */
final class WalkJudge implements Judge {

    static final String LINE_SECONDS = "lineSeconds";
    static final String WAY_METRES = "wayMetres";

    private final Entrant entrant;
    private final double lineMetres;
    private final Map<String, Double> figures = new TreeMap<>();

    /**
     * Begins.
     *
     * @param lineMetres distance of the line from the start
     */
    WalkJudge(ContestTrial trial, double lineMetres) {
        this.entrant = trial.entrants().get(0);
        this.lineMetres = lineMetres;
    }

    @Override
    public boolean watch(JudgedMoment moment, SimulationControl referee) {
        List<RobotView> robots = moment.robots(entrant.team());
        if (robots.isEmpty()) {
            return true;
        }
        RobotView robot = robots.get(0);
        if (robot.isUpright()) {
            double way = robot.torso().x() - entrant.places().get(0).x();
            figures.merge(WAY_METRES, Math.min(way, lineMetres), Math::max);
            if (way >= lineMetres) {
                figures.put(LINE_SECONDS, moment.seconds());
            }
        }
        return figures.containsKey(LINE_SECONDS);
    }

    @Override
    public Map<String, Double> figures(String team) {
        return figures;
    }
}
