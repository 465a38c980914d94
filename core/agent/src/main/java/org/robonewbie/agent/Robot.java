package org.robonewbie.agent;

import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.cycle.Commands;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.agent.cycle.SensorState;
import org.robonewbie.agent.log.Logger;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.agent.perception.CameraPicture;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.HeardMessage;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.telemetry.Drawing;

/**
 * The hardware of the robot: getters are its sensors as of the last message, setters are its motors and its loudspeaker for the
 * next. A value that the robot cannot use is ignored or clamped, and reported once.
 *
 * <p>Units are degrees, metres, seconds and newtons. Vectors have x forward, y to the left and z up, relative to the robot.
 * (SimSpark's own messages have x to the right and y forward; they are converted on reception.) A command takes effect in the
 * message after the next, since one message is always under way.
 *
 * <p>Drawings appear in the studio's picture of the robot's surroundings. All drawings of one cycle form a picture, which stays
 * until the next one, for a second at most. Their points are metres from the centre of the head, as in the field view; colours
 * are CSS names or codes, such as {@code red} or {@code #ff8800}. A finished program may keep them: without a studio they do nothing.
 */
public class Robot {

    private final RobotRuntime runtime;

    Robot(RobotRuntime runtime) {
        this.runtime = runtime;
    }

    final RobotRuntime runtime() {
        return runtime;
    }

    private SensorState sensors() {
        return runtime.sensors();
    }

    private Commands commands() {
        return runtime.commands();
    }

    /** {@return the log, printed when the run is over} */
    public final Logger log() {
        return runtime.log();
    }

    /** {@return simulated seconds since the simulator was started; grows by 0.02 in each cycle} */
    public final double getTime() {
        return sensors().seconds();
    }

    /**
     * Reads the sensor of a joint.
     *
     * @param joint the joint
     * @return its angle in degrees, normally within the joint's range; each cycle
     */
    public final double getJointAngle(Joint joint) {
        return sensors().joints().degrees(joint);
    }

    /**
     * Reads the gyroscope in the torso.
     *
     * @return turning speed in degrees per second: x is positive while the right side goes down, y while the robot bends
     *     forward, z while it turns left; each cycle
     */
    public final Vector3 getGyro() {
        return sensors().torso().gyro();
    }

    /**
     * Reads the accelerometer in the torso.
     *
     * @return specific force in m/s²: x forward, y left, z up; about (0, 0, 9.81) at rest, with strong shocks while walking;
     *     updated in each cycle
     */
    public final Vector3 getAcceleration() {
        return sensors().torso().acceleration();
    }

    /** {@return where and how strongly the ground presses on the left sole; no force in the air; each cycle} */
    public final FootPressure getLeftFootPressure() {
        return sensors().leftFoot();
    }

    /** {@return where and how strongly the ground presses on the right sole; no force in the air; each cycle} */
    public final FootPressure getRightFootPressure() {
        return sensors().rightFoot();
    }

    /**
     * Reads the camera. {@code LocalFieldView} remembers what it sees and is easier to use.
     *
     * @return what the camera recognises, relative to the head as it is turned now; empty in two of three cycles
     */
    public final Optional<CameraPicture> getVision() {
        return sensors().picture();
    }

    /** {@return messages from other robots; usually empty. Your own messages are not included} */
    public final List<HeardMessage> getHeard() {
        return sensors().heard();
    }

    /** {@return the referee's play mode; the last one that this framework knows} */
    public final PlayMode getPlayMode() {
        return sensors().playMode();
    }

    /** {@return seconds of play; does not grow before the kick-off} */
    public final double getPlayTime() {
        return sensors().playSeconds();
    }

    /** {@return the half that this team defends; left until the referee has said something else} */
    public final TeamSide getTeamSide() {
        return sensors().side();
    }

    /** {@return the name of the robot's team} */
    public final String getTeam() {
        return sensors().team();
    }

    /** {@return the number on the robot's shirt, 1 to 11; 0 before it has joined a game} */
    public final int getNumber() {
        return sensors().number();
    }

    /** {@return how the robot is built: as the option {@code --type} wants it, else the standard type 0} */
    public final RobotType getType() {
        return sensors().type();
    }

    /** {@return the goals of this team} */
    public final int getOwnScore() {
        return sensors().score(sensors().side());
    }

    /** {@return the goals of the other team} */
    public final int getOpponentScore() {
        return sensors().score(sensors().side().opponent());
    }

    /**
     * Checks whether the robot lies on the ground, by the smoothed accelerometer: about half a second after it has fallen.
     *
     * @return whether the torso leans by more than 60 degrees
     */
    public final boolean isFallen() {
        return getBodyPosition().isFallen();
    }

    /** {@return upright, or the side on which the robot lies, by the smoothed accelerometer} */
    public final BodyPosition getBodyPosition() {
        return sensors().bodyPosition();
    }

    /** {@return the last message as the simulator sent it, an S-expression; empty if the robot has no connection} */
    public final String getRawMessage() {
        return sensors().buffer().toString();
    }

    /**
     * Turns a motor. It keeps turning until it gets another speed or target, or a motion starts, and stops at the end of the
     * joint's range.
     *
     * @param joint the joint
     * @param degreesPerSecond speed from -351.77 to 351.77; 0 stops and holds the joint
     */
    public final void setJointSpeed(Joint joint, double degreesPerSecond) {
        commands().setJointSpeed(joint, degreesPerSecond);
    }

    /**
     * Moves a joint to an angle as fast as it can and holds it there, until it gets another speed or target, or a motion
     * starts.
     *
     * @param joint the joint
     * @param degrees the angle, within the joint's range
     */
    public final void setJointAngle(Joint joint, double degrees) {
        commands().setJointAngle(joint, degrees, joint.maxDegreesPerSecond());
    }

    /**
     * Moves a joint to an angle and holds it there, until it gets another speed or target, or a motion starts.
     *
     * @param joint the joint
     * @param degrees the angle, within the joint's range
     * @param degreesPerSecond how fast it may move, above 0 and up to 351.77
     */
    public final void setJointAngle(Joint joint, double degrees, double degreesPerSecond) {
        commands().setJointAngle(joint, degrees, degreesPerSecond);
    }

    /**
     * Says something; robots up to 50 m away can hear it. There is room for one text in each cycle, the last one counts.
     *
     * @param text 1 to 20 letters, digits and signs, without blanks, brackets, quotes and semicolons
     */
    public final void say(String text) {
        commands().say(text);
    }

    /**
     * Moves the robot to a place on its own half. The referee allows it before a kick-off and after a goal.
     *
     * @param x metres from the centre towards the opponents' goal, so not above 0
     * @param y metres from the centre to the left
     * @param degrees heading; 0 is towards the opponents' goal, positive is left
     */
    public final void beam(double x, double y, double degrees) {
        commands().beam(x, y, degrees);
    }

    /**
     * Moves the robot to a place on its own half. The referee allows it before a kick-off and after a goal.
     *
     * @param pose where to stand
     */
    public final void beam(Pose2d pose) {
        beam(pose.x(), pose.y(), pose.degrees());
    }

    /** {@return whether beaming is allowed: before a kick-off or after a goal} */
    public final boolean isBeamAllowed() {
        return sensors().isBeamAllowed();
    }

    /**
     * Asks the referee for pass mode: for up to four seconds, or until somebody touches the ball, the opponents must stay a metre away from
     * it. The referee grants it in open play to a robot within half a metre of a ball that lies still, if no opponent is within a metre
     * of it, and not more often than every three seconds. The team cannot score in the ten seconds after it, unless a second player
     * touches the ball.
     */
    public final void requestPass() {
        commands().requestPass();
    }

    /**
     * Draws a point.
     *
     * @param place metres from the head
     * @param colour name or code
     */
    public final void drawPoint(Vector3 place, String colour) {
        runtime.telemetry().draw(new Drawing.Point(place, colour));
    }

    /**
     * Draws a straight line.
     *
     * @param from its start, metres from the head
     * @param to its end, metres from the head
     * @param colour name or code
     */
    public final void drawLine(Vector3 from, Vector3 to, String colour) {
        runtime.telemetry().draw(new Drawing.Line(from, to, colour));
    }

    /**
     * Draws a level circle.
     *
     * @param centre metres from the head
     * @param radius in metres
     * @param colour name or code
     */
    public final void drawCircle(Vector3 centre, double radius, String colour) {
        runtime.telemetry().draw(new Drawing.Circle(centre, radius, colour));
    }

    /**
     * Draws a text.
     *
     * @param place metres from the head
     * @param text what it says
     * @param colour name or code
     */
    public final void drawText(Vector3 place, String text, String colour) {
        runtime.telemetry().draw(new Drawing.Text(place, text, colour));
    }

    /**
     * Adds a value to a curve over time in the studio.
     *
     * @param curve name of the curve; each name has one of its own
     * @param value the value in this cycle, in a unit of your choice
     */
    public final void plot(String curve, double value) {
        runtime.telemetry().plot(curve, value);
    }

    /**
     * Shows the robot's believed pose in the studio.
     *
     * @param x metres from the centre towards the opponents' goal
     * @param y metres to the left of that
     * @param headingDegrees heading of the torso; 0 is towards the opponents' goal, positive is left
     */
    public final void publishPose(double x, double y, double headingDegrees) {
        runtime.telemetry().locate(new Pose2d(x, y, headingDegrees));
    }
}
