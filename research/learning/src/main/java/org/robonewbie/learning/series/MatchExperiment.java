package org.robonewbie.learning.series;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.Catalogue;

/**
 * Matches of two agents until the first goal, with noise and without a kick-off. Both start equally far from the ball in the centre, up to
 * 5 m away, on sides that the seed decides. The parameters {@code agent} and {@code opponent} are names of classes, {@code seconds} is the
 * longest duration (300).
 */
public final class MatchExperiment implements Experiment {

    private static final String AGENT = "agent";
    private static final String OPPONENT = "opponent";
    private static final String SECONDS = "seconds";
    private static final double DEFAULT_SECONDS = 300;
    private static final double MIN_METRES = 0.8;
    private static final double MAX_METRES = 5;
    private static final double ASIDE_METRES = 0.5;
    private static final double MAX_DEGREES = 30;

    /** Creates the experiment. */
    public MatchExperiment() {}

    @Override
    public List<String> columns() {
        return List.of("won", "lost", "seconds_played");
    }

    @Override
    public Optional<List<String>> parameters() {
        return Optional.of(List.of(AGENT, OPPONENT, SECONDS));
    }

    @Override
    public double[] run(Map<String, Double> parameters, long seed) throws Exception {
        return run(parameters, Map.of(), seed);
    }

    @Override
    public double[] run(Map<String, Double> numbers, Map<String, String> texts, long seed) throws Exception {
        RandomSource random = new RandomSource(seed);
        double metres = random.between(MIN_METRES, MAX_METRES);
        boolean agentIsLeft = random.between(0, 1) < 0.5;
        Scene scene = Scene.of(start("Left", random, metres), start("Right", random, metres))
                .withBall(Vector3.ZERO);
        Controller agent = Controller.ofAgent(agent(AGENT, texts));
        Controller opponent = Controller.ofAgent(agent(OPPONENT, texts));
        try (Trial trial = Trial.served(scene, seed, agentIsLeft ? agent : opponent, agentIsLeft ? opponent : agent)) {
            trial.allowBeams();
            double longest = numbers.getOrDefault(SECONDS, DEFAULT_SECONDS);
            WorldState now = trial.now();
            while (trial.seconds() < longest && now.leftGoals() + now.rightGoals() == 0) {
                now = trial.step();
            }
            TeamSide own = agentIsLeft ? TeamSide.LEFT : TeamSide.RIGHT;
            return new double[] {now.goals(own), now.goals(own.opponent()), trial.seconds()};
        }
    }

    private static RobotStart start(String team, RandomSource random, double metres) {
        double y = random.between(-ASIDE_METRES, ASIDE_METRES);
        double turn = random.between(-MAX_DEGREES, MAX_DEGREES);
        boolean left = team.equals("Left");
        return RobotStart.at(new Pose2d(left ? -metres : metres, y, turn + (left ? 0 : 180)))
                .withTeam(team, 1);
    }

    private static Agent agent(String parameter, Map<String, String> texts) {
        String name = Optional.ofNullable(texts.get(parameter))
                .orElseThrow(() -> new IllegalArgumentException("The plan names no " + parameter
                        + ". Add a line such as " + parameter + "=org.robonewbie.examples.Agent_Dummy."));
        ClassLoader classes = Thread.currentThread().getContextClassLoader();
        return new Catalogue<>("agent", Agent.class).named(name, classes).get();
    }
}
