package org.robonewbie.learning.optimise;

import java.io.Serializable;
import java.util.Locale;
import java.util.Random;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.measure.Standing;

/**
 * Scene for the trials of an agent. The seed of a trial varies the positions of the robot and the ball, the heading and
 * the noise.
 *
 * @param place the robot's position, in metres from the centre of the field
 * @param degrees the robot's heading; 0 is towards the opponents' goal, positive is left
 * @param ball the position of the ball
 * @param spreadMetres largest offset of the robot and the ball along each axis, 0 to 3; the heading varies by 60
 *     degrees per metre of this offset
 * @param seconds maximum length of a trial, above 0 and at most 3600
 */
public record AgentScene(Vector3 place, double degrees, Vector3 ball, double spreadMetres, double seconds)
        implements Serializable {

    private static final double DEGREES_PER_METRE = 60;

    /** Validates the parameters. */
    public AgentScene {
        if (!(seconds > 0 && seconds <= 3600)) {
            throw new IllegalArgumentException("--seconds must be above 0 and at most 3600, not " + seconds + ".");
        }
        if (!(spreadMetres >= 0 && spreadMetres <= 3)) {
            throw new IllegalArgumentException("--spread must be from 0 to 3 metres, not " + spreadMetres + ".");
        }
    }

    /** Returns the options of {@code robonewbie optimise} for this scene. */
    String commandLine() {
        return String.format(
                Locale.ROOT,
                "--pose %s,%s,%s --ball %s,%s --spread %s --seconds %s",
                place.x(),
                place.y(),
                degrees,
                ball.x(),
                ball.y(),
                spreadMetres,
                seconds);
    }

    /**
     * Runs a trial. If the objective is the time until an event, such as a goal, the trial succeeds if the event occurs;
     * for other objectives, it succeeds if the robot never falls.
     *
     * @param agent a new agent
     * @param objective the objective
     * @param seed the seed of the scene
     * @return the result
     */
    Evaluation evaluate(Agent agent, Objective objective, long seed) {
        Measure measure = objective.measure().get();
        Standing standing = new Standing();
        try (Trial trial = Trial.served(scene(seed), seed, Controller.ofAgent(agent))) {
            if (objective.isTimeToEvent()) {
                trial.run(seconds, measure);
                return new Evaluation(measure.value(), measure.isDecided() ? 1 : 0, 0);
            }
            trial.run(seconds, measure, standing);
            return new Evaluation(measure.value(), standing.hasFallen() ? 0 : 1, 0);
        }
    }

    private Scene scene(long seed) {
        Random random = new Random(11 * seed + 5);
        random.nextLong();
        Vector3 start = near(place, random);
        double heading = degrees + spreadMetres * DEGREES_PER_METRE * between(random);
        return Scene.of(RobotStart.at(new Pose2d(start.x(), start.y(), heading)))
                .withBall(near(ball, random));
    }

    private Vector3 near(Vector3 point, Random random) {
        return point.plus(new Vector3(spreadMetres * between(random), spreadMetres * between(random), 0));
    }

    private static double between(Random random) {
        return 2 * random.nextDouble() - 1;
    }
}
