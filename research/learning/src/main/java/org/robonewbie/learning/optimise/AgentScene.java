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
 * Where and how long a program is tried. Each seed is a scene of its own: the places of robot and ball vary a little, and so
 * does the noise.
 *
 * @param place where the robot stands, in metres from the centre
 * @param degrees its heading; 0 is towards the opponents' goal, positive is left
 * @param ball where the ball lies
 * @param spreadMetres how much the places of robot and ball vary; the robot's heading varies by 60 degrees for each metre of it
 * @param seconds how long a trial lasts at most
 */
public record AgentScene(Vector3 place, double degrees, Vector3 ball, double spreadMetres, double seconds)
        implements Serializable {

    private static final double DEGREES_FOR_EACH_METRE = 60;

    /** Checks the numbers. */
    public AgentScene {
        if (!(seconds > 0 && seconds <= 3600)) {
            throw new IllegalArgumentException("--seconds " + seconds + ": give a number above 0, at most 3600.");
        }
        if (!(spreadMetres >= 0 && spreadMetres <= 3)) {
            throw new IllegalArgumentException("--spread " + spreadMetres + ": give metres from 0 to 3.");
        }
    }

    /** The command line of this scene. */
    String words() {
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
     * Tries a program. It succeeds if it reaches what the objective waits for, such as a goal, and else if it never falls.
     *
     * @param agent the program, which has not done anything yet
     * @param objective what is measured
     * @param seed chooses the scene
     * @return what came out
     */
    Evaluation evaluate(Agent agent, Objective objective, long seed) {
        Measure measure = objective.measure().get();
        Standing standing = new Standing();
        try (Trial trial = Trial.served(scene(seed), seed, Controller.ofAgent(agent))) {
            if (objective.isTimeToReachSomething()) {
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
        double heading = degrees + spreadMetres * DEGREES_FOR_EACH_METRE * between(random);
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
