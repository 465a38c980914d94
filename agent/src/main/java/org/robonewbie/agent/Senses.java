package org.robonewbie.agent;

import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.perception.FallDetector;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.Heard;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** The last readings of all sensors, in the body's frame; a reading that is missing or no number leaves the one before. */
final class Senses {

    static final Joint[] JOINTS = Joint.values();

    private final FallDetector falls = new FallDetector();
    private final TorsoMotion torso = new TorsoMotion();
    private final MessageBuffer buffer = new MessageBuffer();
    private PerceptorMessage message = PerceptorMessage.NOTHING;
    private double seconds;
    private PlayMode playMode = PlayMode.BEFORE_KICK_OFF;
    private double playSeconds;
    private int leftScore;
    private int rightScore;
    private TeamSide side = TeamSide.LEFT;
    private String team = "";
    private int number;
    private boolean joined;

    void accept(PerceptorMessage newMessage) {
        message = newMessage;
        seconds = newMessage.seconds().orElse(seconds);
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

    /** Takes in the gyroscope's reading in SimSpark's frame, as {@link #toBodyFrame}. */
    private void turn(Vector3 raw) {
        if (isFinite(raw)) {
            torso.setGyro(raw.y(), 0 - raw.x(), raw.z());
        }
    }

    /** Takes in the accelerometer's reading in SimSpark's frame, as {@link #toBodyFrame}. */
    private void push(Vector3 raw) {
        if (isFinite(raw)) {
            torso.setAcceleration(raw.y(), 0 - raw.x(), raw.z());
            falls.feel(torso);
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

    void setTeam(String name) {
        team = name;
    }

    /** Takes in who the robot is, which a simulator tells once at the beginning. */
    void introduce(String ownTeam, int ownNumber, TeamSide ownSide) {
        team = ownTeam;
        number = ownNumber;
        side = ownSide;
    }

    /** The bytes of the last message, which the connection fills. */
    MessageBuffer buffer() {
        return buffer;
    }

    String rawMessage() {
        return buffer.toString();
    }

    PerceptorMessage message() {
        return message;
    }

    FallDetector falls() {
        return falls;
    }

    double seconds() {
        return seconds;
    }

    TorsoMotion torso() {
        return torso;
    }

    FootPressure leftFoot() {
        return pressure(message.footForces().left());
    }

    FootPressure rightFoot() {
        return pressure(message.footForces().right());
    }

    List<Heard> heard() {
        List<Heard> heard = message.heard();
        return heard.isEmpty()
                ? heard
                : heard.stream().filter(text -> !text.isOwn()).toList();
    }

    PlayMode playMode() {
        return playMode;
    }

    double playSeconds() {
        return playSeconds;
    }

    int score(TeamSide whose) {
        return whose == TeamSide.LEFT ? leftScore : rightScore;
    }

    TeamSide side() {
        return side;
    }

    String team() {
        return team;
    }

    int number() {
        return number;
    }

    /** Whether the referee has told team side and number. */
    boolean isJoined() {
        return joined;
    }

    private static FootPressure pressure(Optional<FootForce> foot) {
        return foot.map(force -> new FootPressure(toBodyFrame(force.point()), toBodyFrame(force.force())))
                .orElse(FootPressure.NONE);
    }

    /** SimSpark's frame has x to the right and y forward; ours has x forward and y to the left. */
    private static Vector3 toBodyFrame(Vector3 raw) {
        return new Vector3(raw.y(), 0 - raw.x(), raw.z());
    }

    private static boolean isFinite(Vector3 reading) {
        return Double.isFinite(reading.x() + reading.y() + reading.z());
    }
}
