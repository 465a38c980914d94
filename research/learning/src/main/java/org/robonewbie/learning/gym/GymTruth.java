package org.robonewbie.learning.gym;

import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.WorldState;

/** What is true in an episode, without noise and delay, as a row of numbers in the world frame; and whether the task is done. */
final class GymTruth {

    /** Names of the numbers; metres, degrees, metres per second, and 1 or 0. */
    static final List<String> NAMES = List.of(
            "x",
            "y",
            "height",
            "heading",
            "tilt",
            "vx",
            "vy",
            "ball_x",
            "ball_y",
            "ball_vx",
            "ball_vy",
            "fallen",
            "is_success");

    private GymTruth() {}

    /** The numbers of a moment and one of its robots, in the order of the names. */
    static double[] of(WorldState now, Vector3 velocity, int robot, GymTask task) {
        Pose2d place = now.place(robot);
        BodyState body = now.robots().get(robot);
        return new double[] {
            place.x(),
            place.y(),
            body.position().z(),
            place.degrees(),
            body.tiltDegrees(),
            velocity.x(),
            velocity.y(),
            now.ball().x(),
            now.ball().y(),
            now.ballVelocity().x(),
            now.ballVelocity().y(),
            task.hasFallen() ? 1 : 0,
            task.isDone() ? 1 : 0
        };
    }
}
