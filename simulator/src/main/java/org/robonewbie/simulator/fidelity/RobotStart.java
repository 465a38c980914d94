package org.robonewbie.simulator.fidelity;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * Brings a new robot into the state in which a recording begins, on the way that the recorded ones came: put down where the
 * first robot of a team joins, settled there, beamed, and settled again or lifted and falling freely.
 */
final class RobotStart {

    private static final double BEAM_HEIGHT = 0.4;
    private static final double HIGHEST_STANDING_TORSO = 1;
    private static final double GRAVITY = 9.81;
    private static final Vector3 JOINING_PLACE = new Vector3(-14.2, 9.2, BEAM_HEIGHT);
    private static final int STEPS_TO_LAND_AND_SLEEP = 60;
    private static final double SAME_HEIGHT = 2e-6;
    private static final double WAKING_SPEED = 0.001;

    private final SoccerWorld world;
    private final Robot robot;
    private final List<RecordedRow> rows;

    RobotStart(SoccerWorld world, Robot robot, RecordedRun run) {
        this.world = world;
        this.robot = robot;
        this.rows = run.rows();
    }

    void reach(Pose torso) {
        Vector3 place = torso.position();
        double yaw = TorsoAngles.yawDegrees(torso.rotation()) - 90;
        Vector3 beam = new Vector3(tenthsOfMillimetres(place.x()), tenthsOfMillimetres(place.y()), BEAM_HEIGHT);
        if (!beam.equals(JOINING_PLACE)) {
            robot.moveUpright(JOINING_PLACE, yaw);
            step(STEPS_TO_LAND_AND_SLEEP);
        }
        robot.moveUpright(beam, yaw);
        robot.wake();
        if (place.z() > HIGHEST_STANDING_TORSO) {
            step(STEPS_TO_LAND_AND_SLEEP);
            fall(place);
        } else {
            land(place.z());
        }
    }

    /** Steps until the robot is as high and feels the same as in the first row; if that is at rest, lets it sleep. */
    private void land(double height) {
        Optional<Vector3> acceleration = rows.get(0).acceleration();
        for (int i = 0; i < STEPS_TO_LAND_AND_SLEEP; i++) {
            world.step();
            boolean asHigh = Math.abs(robot.torso().position().z() - height) < SAME_HEIGHT;
            if (asHigh && acceleration.map(this::feels).orElse(true)) {
                break;
            }
        }
        if (acceleration.map(felt -> Printed.equal(GRAVITY, felt.z())).orElse(true)) {
            step(STEPS_TO_LAND_AND_SLEEP);
        }
    }

    private boolean feels(Vector3 acceleration) {
        return Printed.equal(robot.acceleration(), acceleration);
    }

    /** The way from the first row to the second tells for how many steps the robot has been falling. */
    private void fall(Vector3 place) {
        double dt = SoccerWorld.STEP_SECONDS;
        double speed = (place.z() - rows.get(1).torso().orElseThrow().position().z()) / dt;
        int steps = (int) Math.round(speed / (GRAVITY * dt)) - 1;
        double way = GRAVITY * dt * dt * steps * (steps + 1) / 2;
        robot.moveTo(new Vector3(
                tenthsOfMillimetres(place.x()), tenthsOfMillimetres(place.y()), tenthsOfMillimetres(place.z() + way)));
        robot.setMotorSpeed(Joint.NECK_YAW, WAKING_SPEED);
        step(1);
        robot.setMotorSpeed(Joint.NECK_YAW, 0);
        step(steps - 1);
    }

    private void step(int count) {
        for (int i = 0; i < count; i++) {
            world.step();
        }
    }

    private static double tenthsOfMillimetres(double metres) {
        return Math.rint(metres * 1e4) / 1e4;
    }
}
