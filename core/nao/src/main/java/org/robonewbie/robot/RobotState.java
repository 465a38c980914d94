package org.robonewbie.robot;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Pose;

/**
 * The true state of a robot of any model: the pose of its torso on the pitch and its joint angles.
 *
 * <pre>{@code
 * RobotState state = new RobotState.OfModel(BoosterT1.MODEL, torso, degrees);
 * double knee = state.degrees(BoosterT1.MODEL.joint("lle4").orElseThrow().index());
 * }</pre>
 */
public sealed interface RobotState {

    /**
     * Returns a state.
     *
     * @param model the model of the robot
     * @param torso pose of the torso's frame in the world frame
     * @param degrees angle of each joint in degrees, in the order of {@link RobotModel#joints()}
     * @return an {@link OfNao} for the model of a NAO, otherwise an {@link OfModel}
     * @throws IllegalArgumentException if the number of angles is not the number of joints
     */
    static RobotState of(RobotModel model, Pose torso, double[] degrees) {
        return NaoRobot.typeOf(model)
                .<RobotState>map(type -> new OfNao(BodyState.ofHinges(type, torso, degrees)))
                .orElseGet(() -> new OfModel(model, torso, degrees));
    }

    /** {@return the model of the robot} */
    RobotModel model();

    /** {@return pose of the torso's frame in the world frame} */
    Pose torso();

    /** {@return the number of joints} */
    int joints();

    /**
     * Returns the angle of a joint.
     *
     * @param joint index of the joint in {@link RobotModel#joints()}
     * @return the angle in degrees
     */
    double degrees(int joint);

    /** {@return whether the robot has fallen: tilted by more than 60 degrees, or the torso lower than half its height in the stance} */
    boolean isFallen();

    /**
     * The state of a NAO.
     *
     * @param body pose of the torso and joint angles
     */
    record OfNao(BodyState body) implements RobotState {

        @Override
        public RobotModel model() {
            return NaoRobot.of(body.type());
        }

        @Override
        public Pose torso() {
            return body.torso();
        }

        @Override
        public int joints() {
            return body.hinges();
        }

        @Override
        public double degrees(int joint) {
            return body.hingeDegrees(joint);
        }

        @Override
        public boolean isFallen() {
            return body.isFallen();
        }
    }

    /** The state of a robot that is described by its model only. Immutable. */
    final class OfModel implements RobotState {

        private static final Vector3 UP = new Vector3(0, 0, 1);

        private final RobotModel model;
        private final Pose torso;
        private final double[] degrees;

        /**
         * Creates a state.
         *
         * @param model the model of the robot
         * @param torso pose of the torso's frame in the world frame
         * @param degrees angle of each joint in degrees, in the order of {@link RobotModel#joints()}; copied
         * @throws IllegalArgumentException if the number of angles is not the number of joints
         */
        public OfModel(RobotModel model, Pose torso, double[] degrees) {
            if (degrees.length != model.joints().size()) {
                throw new IllegalArgumentException("Robot " + model.name() + " has "
                        + model.joints().size() + " joints, but " + degrees.length + " angles were given.");
            }
            this.model = model;
            this.torso = torso;
            this.degrees = degrees.clone();
        }

        @Override
        public RobotModel model() {
            return model;
        }

        @Override
        public Pose torso() {
            return torso;
        }

        @Override
        public int joints() {
            return degrees.length;
        }

        @Override
        public double degrees(int joint) {
            return degrees[joint];
        }

        @Override
        public boolean isFallen() {
            double tilt = BodyState.tiltDegrees(torso.rotation().apply(UP));
            return tilt > BodyState.FALLEN_DEGREES || torso.position().z() < model.stanceHeight() / 2;
        }
    }
}
