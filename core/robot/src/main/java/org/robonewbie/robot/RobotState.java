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

    /** {@return whether the robot is on its feet, as defined by {@link #isStanding(RobotModel, double, double)}} */
    boolean isStanding();

    /** {@return whether the robot has fallen, as defined by {@link #isFallen(RobotModel, double, double)}} */
    boolean isFallen();

    /**
     * Returns whether a robot is on its feet: tilted by less than 30 degrees, and the torso higher than 65 % of its height in the
     * stance; for a NAO, as defined by {@link BodyState#isStanding(double, double)}.
     *
     * @param model the model
     * @param tiltDegrees tilt of the torso in degrees
     * @param torsoMetres height of the torso's frame above the ground in metres
     * @return whether the robot is standing
     */
    static boolean isStanding(RobotModel model, double tiltDegrees, double torsoMetres) {
        return NaoRobot.isNao(model)
                ? BodyState.isStanding(tiltDegrees, torsoMetres)
                : tiltDegrees < BodyState.STANDING_DEGREES && torsoMetres > 0.65 * model.stanceHeight();
    }

    /**
     * Returns whether a robot has fallen: tilted by more than 60 degrees, or the torso lower than half its height in the stance; for
     * a NAO, as defined by {@link BodyState#isFallen(double, double)}.
     *
     * @param model the model
     * @param tiltDegrees tilt of the torso in degrees
     * @param torsoMetres height of the torso's frame above the ground in metres
     * @return whether the robot has fallen
     */
    static boolean isFallen(RobotModel model, double tiltDegrees, double torsoMetres) {
        return NaoRobot.isNao(model)
                ? BodyState.isFallen(tiltDegrees, torsoMetres)
                : tiltDegrees > BodyState.FALLEN_DEGREES || torsoMetres < 0.5 * model.stanceHeight();
    }

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
        public boolean isStanding() {
            return body.isStanding();
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
        public boolean isStanding() {
            return RobotState.isStanding(model, tiltDegrees(), torso.position().z());
        }

        @Override
        public boolean isFallen() {
            return RobotState.isFallen(model, tiltDegrees(), torso.position().z());
        }

        private double tiltDegrees() {
            return BodyState.tiltDegrees(torso.rotation().apply(UP));
        }
    }
}
