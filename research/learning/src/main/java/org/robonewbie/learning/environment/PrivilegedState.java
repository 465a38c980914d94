package org.robonewbie.learning.environment;

import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.trial.WorldState;

/** Ground-truth state of an episode in the world frame, without noise or delay, and whether the task has succeeded. */
final class PrivilegedState {

    /** Names of the components. Their units are metres, degrees and metres per second; boolean values are 1 or 0. */
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

    private PrivilegedState() {}

    /** Returns the state of a task's robot, in the order of {@link #NAMES}. */
    static double[] of(WorldState now, Vector3 velocity, TrainingTask task) {
        Pose2d place = now.place(task.robot());
        BodyState body = now.robots().get(task.robot());
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
