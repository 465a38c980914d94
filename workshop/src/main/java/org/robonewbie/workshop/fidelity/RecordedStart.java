package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.Robot;

/**
 * Brings a new robot to the initial state of a recording through the same steps as the original: placed at the first
 * start position of a team, settled, beamed, and settled again; or lifted, then either held in the air with its bodies
 * asleep or left to fall freely.
 */
final class RecordedStart {

    private static final double BEAM_HEIGHT = RecordedCommands.BEAM_HEIGHT;
    private static final double MAX_STANDING_TORSO_HEIGHT = 0.45;
    private static final double GRAVITY = 9.81;
    private static final double JOINING_SPACING = 1.2;
    private static final int STEPS_TO_LAND_AND_SLEEP = 60;
    private static final double PRINTED_METRES = 2e-5;
    private static final double SAME_HEIGHT = 2e-6;
    private static final double WAKING_SPEED = 0.001;

    private final ReplayStage stage;
    private final Robot robot;
    private final List<RecordedRow> rows;
    private final JoiningWay way;

    RecordedStart(ReplayStage stage, RecordedRun run, JoiningWay way) {
        this.stage = stage;
        this.robot = stage.robot();
        this.rows = run.rows();
        this.way = way;
    }

    void reach(BodyPose torso) throws IOException {
        rows.get(0).ball().ifPresent(this::placeBall);
        Vector3 place = torso.position();
        double yaw = TorsoAngles.yawDegrees(torso.rotation()) - 90;
        Vector3 beam = new Vector3(tenthsOfMillimetres(place.x()), tenthsOfMillimetres(place.y()), BEAM_HEIGHT);
        if (!isJoiningPosition(beam)) {
            step(way.cyclesToBeam() - 1);
        }
        robot.moveUpright(beam, yaw);
        robot.wake();
        if (way.cyclesToFirstRow() > 0) {
            step(way.cyclesToFirstRow());
        } else if (place.z() > MAX_STANDING_TORSO_HEIGHT) {
            step(STEPS_TO_LAND_AND_SLEEP);
            lift(place);
        } else {
            land(place.z());
        }
        shiftTo(place);
    }

    /** Places the ball. A resting ball sinks slightly into the ground and is placed at the height of first contact. */
    private void placeBall(Vector3 place) {
        double radius = stage.ball().properties().radius();
        stage.placeBall(place.z() < radius ? new Vector3(place.x(), place.y(), radius) : place);
    }

    /** Corrects the position of a resting robot, because a server with noise does not beam robots exactly to their targets. */
    private void shiftTo(Vector3 place) {
        Vector3 torso = robot.torso().position();
        if (robot.isAsleep() && Math.hypot(place.x() - torso.x(), place.y() - torso.y()) > PRINTED_METRES) {
            robot.moveTo(new Vector3(place.x(), place.y(), torso.z()));
        }
    }

    /**
     * Returns whether a position is a start position: new players appear in a row along the side line of their half.
     */
    private boolean isJoiningPosition(Vector3 place) {
        double index = (way.place().y() - place.y()) / JOINING_SPACING;
        return Math.abs(place.x()) == Math.abs(way.place().x())
                && index > -1e-6
                && Math.abs(index - Math.rint(index)) < 1e-6;
    }

    /**
     * Steps until the height and acceleration equal those in the first row. If the robot is at rest in that row, continues until the robot
     * is asleep.
     */
    private void land(double height) throws IOException {
        Optional<Vector3> acceleration = rows.get(0).acceleration();
        for (int i = 0; i < STEPS_TO_LAND_AND_SLEEP; i++) {
            step(1);
            boolean asHigh = Math.abs(robot.torso().position().z() - height) < SAME_HEIGHT;
            if (asHigh && acceleration.map(this::measures).orElse(true)) {
                break;
            }
        }
        if (acceleration.map(value -> Printed.equal(GRAVITY, value.z())).orElse(true)) {
            step(STEPS_TO_LAND_AND_SLEEP);
        }
    }

    private boolean measures(Vector3 acceleration) {
        return Printed.equal(robot.acceleration(), acceleration);
    }

    /**
     * Lifts the robot. The displacement between the first two rows determines for how many steps it has been falling.
     */
    private void lift(Vector3 place) throws IOException {
        double dt = Cycle.SECONDS;
        double speed = rows.size() < 2 ? 0 : (place.z() - heightInSecondRow(place)) / dt;
        int steps = (int) Math.max(0, Math.round(speed / (GRAVITY * dt)) - 1);
        double way = GRAVITY * dt * dt * steps * (steps + 1) / 2;
        robot.moveTo(new Vector3(
                tenthsOfMillimetres(place.x()), tenthsOfMillimetres(place.y()), tenthsOfMillimetres(place.z() + way)));
        if (steps > 0) {
            robot.setMotorSpeed(Joint.NECK_YAW, WAKING_SPEED);
            step(1);
            robot.setMotorSpeed(Joint.NECK_YAW, 0);
            step(steps - 1);
        }
    }

    private double heightInSecondRow(Vector3 place) {
        return rows.get(1).torso().map(torso -> torso.position().z()).orElse(place.z());
    }

    private void step(int count) throws IOException {
        for (int i = 0; i < count; i++) {
            stage.step(List.of());
        }
    }

    private static double tenthsOfMillimetres(double metres) {
        return Math.rint(metres * 1e4) / 1e4;
    }
}
