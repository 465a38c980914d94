package org.robonewbie.agent.cycle;

import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.agent.perception.CameraPicture;
import org.robonewbie.agent.perception.FallDetector;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.HeardMessage;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/**
 * The last readings of all sensors, in the body frame (x forward, y left, z up); a missing or non-finite reading leaves
 * the previous value unchanged.
 */
public final class SensorState {

    static final Joint[] JOINTS = Joint.values();

    private static final ForwardKinematics NAO = ForwardKinematics.of(RobotType.TYPE_0);

    private final JointStates joints = new JointStates();
    private final FallDetector falls = new FallDetector();
    private TorsoMotion torso = TorsoMotion.AT_REST;
    private final MessageBuffer buffer = new MessageBuffer();
    private PerceptorMessage message = PerceptorMessage.NOTHING;
    private double seconds;
    private PlayMode playMode = PlayMode.BEFORE_KICK_OFF;
    private double playSeconds;
    private int leftScore;
    private int rightScore;
    private TeamSide side = TeamSide.LEFT;
    private String team = "";
    private RobotType type = RobotType.TYPE_0;
    private int number;
    private boolean joined;
    private CameraKinematics camera = NAO::camera;
    private boolean hasFootSensors = true;
    private String modelName = "NAO";
    private Optional<OwnJoints> ownJoints = Optional.empty();

    /** Creates the state of a robot at rest. */
    public SensorState() {}

    /**
     * Processes a message.
     *
     * @param newMessage the perceptors' readings
     */
    public void accept(PerceptorMessage newMessage) {
        message = newMessage;
        seconds = newMessage.seconds().orElse(seconds);
        for (Joint joint : JOINTS) {
            joints.sense(joint, newMessage.jointAngles().degreesOr(joint, Double.NaN));
        }
        if (newMessage.gyro().isPresent()) {
            updateGyro(newMessage.gyro().get());
        }
        if (newMessage.accelerometer().isPresent()) {
            updateAccelerometer(newMessage.accelerometer().get());
        }
        if (newMessage.gameState().isPresent()) {
            accept(newMessage.gameState().get());
        }
    }

    private void updateGyro(Vector3 raw) {
        if (isFinite(raw)) {
            torso = torso.withGyro(SimSparkFrame.toBody(raw));
        }
    }

    private void updateAccelerometer(Vector3 raw) {
        if (isFinite(raw)) {
            torso = torso.withAcceleration(SimSparkFrame.toBody(raw));
            falls.update(torso);
        }
    }

    private void accept(GameState state) {
        playMode = state.playMode().orElse(playMode);
        playSeconds = state.playSeconds();
        leftScore = state.leftScore().orElse(leftScore);
        rightScore = state.rightScore().orElse(rightScore);
        number = state.number().orElse(number);
        side = state.side().orElse(side);
        joined |= state.side().isPresent() && state.number().isPresent();
    }

    /**
     * Sets the team name, which no message contains.
     *
     * @param name name of the team
     */
    public void setTeam(String name) {
        team = name;
    }

    /**
     * Sets the robot type.
     *
     * @param asked the type that the robot requested
     */
    public void setType(RobotType asked) {
        type = asked;
    }

    /**
     * Sets the equipment of a robot other than a NAO.
     *
     * @param newModelName name of its model
     * @param newCamera where its camera is
     * @param footSensors whether it has force sensors in its feet
     * @param newOwnJoints its joints, if it is a T1
     */
    public void setEquipment(
            String newModelName, CameraKinematics newCamera, boolean footSensors, Optional<OwnJoints> newOwnJoints) {
        modelName = newModelName;
        ownJoints = newOwnJoints;
        camera = newCamera;
        hasFootSensors = footSensors;
    }

    /** {@return the pose of the camera in the torso's frame, according to the angles of the neck} */
    public Pose cameraPose() {
        return camera.pose(joints.degrees(Joint.NECK_YAW), joints.degrees(Joint.NECK_PITCH));
    }

    /** {@return name of the robot's model} */
    public String modelName() {
        return modelName;
    }

    /** {@return the joints of a T1 with their own angles; empty for other robots} */
    public Optional<OwnJoints> ownJoints() {
        return ownJoints;
    }

    /** {@return whether the robot has force sensors in its feet} */
    public boolean hasFootSensors() {
        return hasFootSensors;
    }

    /** {@return the robot type; type 0 by default} */
    public RobotType type() {
        return type;
    }

    /**
     * Sets the identity that a simulator would assign.
     *
     * @param ownTeam name of the team
     * @param ownNumber the player number
     * @param ownSide the half that the team defends
     */
    public void introduce(String ownTeam, int ownNumber, TeamSide ownSide) {
        team = ownTeam;
        number = ownNumber;
        side = ownSide;
    }

    /** {@return the text of the last message, filled by the connection} */
    public MessageBuffer buffer() {
        return buffer;
    }

    /** {@return the angles of all joints} */
    public JointStates joints() {
        return joints;
    }

    /** {@return the fall detector} */
    public FallDetector falls() {
        return falls;
    }

    /** {@return the orientation of the torso: upright, or the side on which the robot is lying} */
    public BodyPosition bodyPosition() {
        return falls.bodyPosition();
    }

    /** {@return simulated time in seconds} */
    public double seconds() {
        return seconds;
    }

    /** {@return the readings of the gyroscope and the accelerometer} */
    public TorsoMotion torso() {
        return torso;
    }

    /** {@return the force on the left sole} */
    public FootPressure leftFoot() {
        return pressure(message.footForces().left());
    }

    /** {@return the force on the right sole} */
    public FootPressure rightFoot() {
        return pressure(message.footForces().right());
    }

    /** {@return the camera picture; empty in two out of three cycles} */
    public Optional<CameraPicture> picture() {
        return message.vision().map(Pictures::of);
    }

    /** {@return messages from other robots} */
    public List<HeardMessage> heard() {
        return message.heard().stream()
                .filter(heard -> !heard.isOwn())
                .map(heard -> new HeardMessage(heard.text(), heard.team(), heard.directionDegrees()))
                .toList();
    }

    /** {@return the play mode} */
    public PlayMode playMode() {
        return playMode;
    }

    /** {@return whether the game is waiting for a kick-off, or a goal has just been scored} */
    public boolean isBeamAllowed() {
        return switch (playMode) {
            case BEFORE_KICK_OFF, GOAL_LEFT, GOAL_RIGHT -> true;
            default -> false;
        };
    }

    /** {@return the game clock in seconds} */
    public double playSeconds() {
        return playSeconds;
    }

    /**
     * Returns the number of goals that a team has scored.
     *
     * @param teamSide side of the team
     * @return its number of goals
     */
    public int score(TeamSide teamSide) {
        return teamSide == TeamSide.LEFT ? leftScore : rightScore;
    }

    /** {@return the half that the robot's team defends} */
    public TeamSide side() {
        return side;
    }

    /** {@return the name of the robot's team} */
    public String team() {
        return team;
    }

    /** {@return the player number; 0 before it is known} */
    public int number() {
        return number;
    }

    /** {@return whether the referee has assigned a side and a number} */
    public boolean isJoined() {
        return joined;
    }

    private static FootPressure pressure(Optional<FootForce> foot) {
        return foot.map(force ->
                        new FootPressure(SimSparkFrame.toBody(force.point()), SimSparkFrame.toBody(force.force())))
                .orElse(FootPressure.NONE);
    }

    private static boolean isFinite(Vector3 reading) {
        return Double.isFinite(reading.x() + reading.y() + reading.z());
    }
}
