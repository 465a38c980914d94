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
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** The last readings of all sensors, in the body's frame; a reading that is missing or no number leaves the one before. */
public final class SensorState {

    static final Joint[] JOINTS = Joint.values();

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

    /** Creates the senses of a robot at rest. */
    public SensorState() {}

    /**
     * Takes in a message.
     *
     * @param newMessage what the robot senses
     */
    public void accept(PerceptorMessage newMessage) {
        message = newMessage;
        seconds = newMessage.seconds().orElse(seconds);
        for (Joint joint : JOINTS) {
            joints.sense(joint, newMessage.jointAngles().degreesOr(joint, Double.NaN));
        }
        if (newMessage.gyro().isPresent()) {
            turn(newMessage.gyro().get());
        }
        if (newMessage.accelerometer().isPresent()) {
            push(newMessage.accelerometer().get());
        }
        if (newMessage.gameState().isPresent()) {
            accept(newMessage.gameState().get());
        }
    }

    /** Takes in the gyroscope's reading in SimSpark's frame. */
    private void turn(Vector3 raw) {
        if (isFinite(raw)) {
            torso = torso.withGyro(SimSparkFrame.toBody(raw));
        }
    }

    /** Takes in the accelerometer's reading in SimSpark's frame. */
    private void push(Vector3 raw) {
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
     * Sets the team, which no message tells.
     *
     * @param name the team's name
     */
    public void setTeam(String name) {
        team = name;
    }

    /**
     * Sets how the robot is built, as it was asked for.
     *
     * @param asked the robot type
     */
    public void setType(RobotType asked) {
        type = asked;
    }

    /** {@return how the robot is built; type 0 unless another one was asked for} */
    public RobotType type() {
        return type;
    }

    /**
     * Sets who the robot is, which a simulator tells once at the beginning.
     *
     * @param ownTeam the team's name
     * @param ownNumber the number on the shirt
     * @param ownSide the half that the team defends
     */
    public void introduce(String ownTeam, int ownNumber, TeamSide ownSide) {
        team = ownTeam;
        number = ownNumber;
        side = ownSide;
    }

    /** {@return the bytes of the last message, which the connection fills} */
    public MessageBuffer buffer() {
        return buffer;
    }

    /** {@return the angles of all joints} */
    public JointStates joints() {
        return joints;
    }

    /** {@return the detector of falls} */
    public FallDetector falls() {
        return falls;
    }

    /** {@return upright, or the side on which the robot lies} */
    public BodyPosition bodyPosition() {
        return falls.bodyPosition();
    }

    /** {@return simulated time in seconds} */
    public double seconds() {
        return seconds;
    }

    /** {@return the readings of gyroscope and accelerometer} */
    public TorsoMotion torso() {
        return torso;
    }

    /** {@return what the left sole feels} */
    public FootPressure leftFoot() {
        return pressure(message.footForces().left());
    }

    /** {@return what the right sole feels} */
    public FootPressure rightFoot() {
        return pressure(message.footForces().right());
    }

    /** {@return the picture of the camera; empty in two of three cycles} */
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

    /** {@return whether the game waits for a kick-off or a goal was just scored} */
    public boolean isBeamAllowed() {
        return switch (playMode) {
            case BEFORE_KICK_OFF, GOAL_LEFT, GOAL_RIGHT -> true;
            default -> false;
        };
    }

    /** {@return time of play in seconds} */
    public double playSeconds() {
        return playSeconds;
    }

    /**
     * Returns the goals of a team.
     *
     * @param whose the team that plays from this side
     * @return its goals
     */
    public int score(TeamSide whose) {
        return whose == TeamSide.LEFT ? leftScore : rightScore;
    }

    /** {@return the half that the robot's team defends} */
    public TeamSide side() {
        return side;
    }

    /** {@return the name of the robot's team} */
    public String team() {
        return team;
    }

    /** {@return the number on the shirt; 0 before it is known} */
    public int number() {
        return number;
    }

    /** {@return whether the referee has told team side and number} */
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
