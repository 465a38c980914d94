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
import org.robonewbie.nao.T1Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.telemetry.Drawing;

/**
 * The robot's hardware: getters read its sensors as of the last message, setters command its motors and its loudspeaker for the
 * next one. Values that the robot cannot use are ignored or clamped, and reported once.
 *
 * <p>Units are degrees, metres, seconds and newtons. Vectors have x forward, y to the left and z up, relative to the
 * robot. (SimSpark's own messages have x to the right and y forward; they are converted on reception.) A command takes
 * effect two messages later, because one message is always in transit.
 *
 * <p>Drawings appear in the studio's view of the robot's surroundings. All drawings of one cycle form a picture, which
 * is shown until the next one, but for at most a second. Points are relative to the centre of the head, in metres, as
 * in the field view; colours are CSS names or codes, such as {@code red} or {@code #ff8800}. Without a studio, drawings
 * have no effect, so a finished program may keep them.
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

    /** {@return simulated seconds since the simulator was started; increases by 0.02 in each cycle} */
    public final double getTime() {
        return sensors().seconds();
    }

    /**
     * Reads a joint's angle sensor, updated in each cycle.
     *
     * @param joint the joint
     * @return the angle in degrees, normally within the joint's range
     */
    public final double getJointAngle(Joint joint) {
        return sensors().joints().degrees(joint);
    }

    /**
     * Reads a joint's angle sensor of a T1, updated in each cycle.
     *
     * @param joint the joint
     * @return the angle in degrees, as the league's server measures it; 0 for a robot that is not a T1
     */
    public final double getJointAngle(T1Joint joint) {
        reportOtherRobot();
        return sensors().ownJoints().map(joints -> joints.degrees(joint)).orElse(0.0);
    }

    private void reportOtherRobot() {
        if (sensors().ownJoints().isEmpty()) {
            runtime.diagnostics()
                    .report(
                            "joints of a T1",
                            () -> "This robot is a " + getModelName()
                                    + ", which does not have the joints of a T1: run the program with --robot T1, or use Joint.");
        }
    }

    /**
     * Reads the gyroscope in the torso, updated in each cycle.
     *
     * @return angular velocity in degrees per second: x is positive while the robot tilts to its right, y while it tilts
     *     forward, z while it turns left
     */
    public final Vector3 getGyro() {
        return sensors().torso().gyro();
    }

    /**
     * Reads the accelerometer in the torso, updated in each cycle.
     *
     * @return specific force in m/s²: x forward, y left, z up; about (0, 0, 9.81) at rest, with strong shocks while walking
     */
    public final Vector3 getAcceleration() {
        return sensors().torso().acceleration();
    }

    /**
     * Reads the force sensor of a foot, updated in each cycle.
     *
     * @param leg the leg
     * @return the force on the sole and the point where it acts; the force is zero while the foot is in the air; empty if the robot
     *     has no force sensors in its feet, such as a T1
     */
    public final Optional<FootPressure> getFootPressure(Leg leg) {
        return sensors().hasFootSensors()
                ? Optional.of(leg == Leg.LEFT ? sensors().leftFoot() : sensors().rightFoot())
                : Optional.empty();
    }

    /**
     * {@return the force on the left sole and the point where it acts, updated in each cycle; the force is zero while the
     * foot is in the air, and for a robot without force sensors}
     */
    public final FootPressure getLeftFootPressure() {
        reportMissingFootSensors();
        return sensors().leftFoot();
    }

    /**
     * {@return the force on the right sole and the point where it acts, updated in each cycle; the force is zero while the
     * foot is in the air, and for a robot without force sensors}
     */
    public final FootPressure getRightFootPressure() {
        reportMissingFootSensors();
        return sensors().rightFoot();
    }

    private void reportMissingFootSensors() {
        if (!sensors().hasFootSensors()) {
            runtime.diagnostics()
                    .report(
                            "foot sensors",
                            () -> "This robot has no force sensors in its feet, so the force is always 0:"
                                    + " getFootPressure(leg) is empty for such robots.");
        }
    }

    /**
     * Reads the camera. {@code LocalFieldView} remembers the sightings and is easier to use.
     *
     * @return the objects in view, relative to the current pose of the head; empty in two out of three cycles
     */
    public final Optional<CameraPicture> getVision() {
        return sensors().picture();
    }

    /** {@return the pose of the camera in the torso's frame, according to the angle sensors of the neck} */
    public final Pose getCameraPose() {
        return sensors().cameraPose();
    }

    /** {@return messages from other robots in this cycle, usually none; the robot's own messages are not included} */
    public final List<HeardMessage> getHeard() {
        return sensors().heard();
    }

    /** {@return the referee's play mode; if the server sends an unknown mode, the last known one} */
    public final PlayMode getPlayMode() {
        return sensors().playMode();
    }

    /** {@return the game clock in seconds; it starts at the kick-off} */
    public final double getPlayTime() {
        return sensors().playSeconds();
    }

    /** {@return the half that the robot's team defends; {@code LEFT} until the referee has assigned one} */
    public final TeamSide getTeamSide() {
        return sensors().side();
    }

    /** {@return the name of the robot's team} */
    public final String getTeam() {
        return sensors().team();
    }

    /** {@return the player number, 1 to 11; 0 before the robot has joined a game} */
    public final int getNumber() {
        return sensors().number();
    }

    /** {@return the model of the robot: {@code NAO}, {@code T1} or {@code K1}} */
    public final String getModelName() {
        return sensors().modelName();
    }

    /** {@return the robot type, as set by the option {@code --type}; type 0 by default} */
    public final RobotType getType() {
        return sensors().type();
    }

    /** {@return the number of goals that the robot's team has scored} */
    public final int getOwnScore() {
        return sensors().score(sensors().side());
    }

    /** {@return the number of goals that the opponents have scored} */
    public final int getOpponentScore() {
        return sensors().score(sensors().side().opponent());
    }

    /**
     * Checks whether the robot has fallen, using smoothed accelerometer readings; a fall is detected after about half a
     * second.
     *
     * @return whether the torso is tilted by more than 60 degrees
     */
    public final boolean isFallen() {
        return getBodyPosition().isFallen();
    }

    /** {@return the orientation of the torso according to smoothed accelerometer readings} */
    public final BodyPosition getBodyPosition() {
        return sensors().bodyPosition();
    }

    /** {@return the last message from the simulator, an S-expression; empty without a connection} */
    public final String getRawMessage() {
        return sensors().buffer().toString();
    }

    /**
     * Sets the speed of a joint. The speed stays in effect until another speed or target is set or a motion starts; the
     * joint stops at the end of its range.
     *
     * @param joint the joint
     * @param degreesPerSecond speed from -351.77 to 351.77; 0 stops and holds the joint
     */
    public final void setJointSpeed(Joint joint, double degreesPerSecond) {
        commands().setJointSpeed(joint, degreesPerSecond);
    }

    /**
     * Moves a joint to an angle at full speed and holds it there, until another speed or target is set or a motion starts.
     *
     * @param joint the joint
     * @param degrees target angle, within the joint's range
     */
    public final void setJointAngle(Joint joint, double degrees) {
        commands().setJointAngle(joint, degrees, joint.maxDegreesPerSecond());
    }

    /**
     * Moves a joint to an angle and holds it there, until another speed or target is set or a motion starts.
     *
     * @param joint the joint
     * @param degrees target angle, within the joint's range
     * @param degreesPerSecond maximum speed, above 0 and up to 351.77
     */
    public final void setJointAngle(Joint joint, double degrees, double degreesPerSecond) {
        commands().setJointAngle(joint, degrees, degreesPerSecond);
    }

    /**
     * Moves a joint of a T1 to an angle and holds it there, with the stiffness and damping with which the robot stands. The target
     * stays in effect until another one is set, the robot starts to walk, falls or is placed. While the robot walks, only the head
     * obeys. Targets for the legs replace those that hold the robot upright.
     *
     * @param joint the joint
     * @param degrees target angle, within the joint's range
     */
    public final void setJointAngle(T1Joint joint, double degrees) {
        reportOtherRobot();
        commands().setJointAngle(joint, degrees);
    }

    /**
     * Moves a joint of a T1 to an angle and holds it there with given gains: torque = stiffness · (target − angle) − damping · speed,
     * limited to the motor's maximum.
     *
     * @param joint the joint
     * @param degrees target angle, within the joint's range
     * @param stiffness 0 to 500 newton metres per radian
     * @param damping 0 to 20 newton metres per radian per second; more than 2 makes a foot in the air vibrate
     * @see #setJointAngle(T1Joint, double)
     */
    public final void setJointAngle(T1Joint joint, double degrees, double stiffness, double damping) {
        reportOtherRobot();
        commands().setJointAngle(joint, degrees, stiffness, damping);
    }

    /**
     * Broadcasts a message to robots within 50 m. Only the last call in a cycle counts.
     *
     * @param text 1 to 20 printable ASCII characters other than spaces, brackets, quotes and semicolons
     */
    public final void say(String text) {
        commands().say(text);
    }

    /**
     * Beams the robot to a pose in its own half. The referee allows this only before a kick-off and after a goal.
     *
     * @param x metres from the centre towards the opponents' goal, at most 0
     * @param y metres to the left of the centre
     * @param degrees heading; 0 is towards the opponents' goal, positive is left
     */
    public final void beam(double x, double y, double degrees) {
        commands().beam(x, y, degrees);
    }

    /**
     * Beams the robot to a pose in its own half. The referee allows this only before a kick-off and after a goal.
     *
     * @param pose metres and degrees in the coordinates of the robot's team
     */
    public final void beam(Pose2d pose) {
        beam(pose.x(), pose.y(), pose.degrees());
    }

    /** {@return whether beaming is allowed: before a kick-off or after a goal} */
    public final boolean isBeamAllowed() {
        return sensors().isBeamAllowed();
    }

    /**
     * Requests pass mode: opponents must stay a metre away from the ball for up to four seconds, or until the ball is touched.
     * The referee grants it in open play to a robot within half a metre of a stationary ball, if no opponent is within
     * a metre of the ball, and at most once every three seconds. The team cannot score in the following ten seconds
     * unless a second player touches the ball.
     */
    public final void requestPass() {
        commands().requestPass();
    }

    /**
     * Draws a point.
     *
     * @param place position relative to the centre of the head, in metres
     * @param colour CSS name or code
     */
    public final void drawPoint(Vector3 place, String colour) {
        runtime.telemetry().draw(new Drawing.Point(place, colour));
    }

    /**
     * Draws a line.
     *
     * @param from start point relative to the centre of the head, in metres
     * @param to end point relative to the centre of the head, in metres
     * @param colour CSS name or code
     */
    public final void drawLine(Vector3 from, Vector3 to, String colour) {
        runtime.telemetry().draw(new Drawing.Line(from, to, colour));
    }

    /**
     * Draws a horizontal circle.
     *
     * @param centre centre of the circle relative to the centre of the head, in metres
     * @param radius radius in metres
     * @param colour CSS name or code
     */
    public final void drawCircle(Vector3 centre, double radius, String colour) {
        runtime.telemetry().draw(new Drawing.Circle(centre, radius, colour));
    }

    /**
     * Draws text.
     *
     * @param place position relative to the centre of the head, in metres
     * @param text the text
     * @param colour CSS name or code
     */
    public final void drawText(Vector3 place, String text, String colour) {
        runtime.telemetry().draw(new Drawing.Text(place, text, colour));
    }

    /**
     * Adds a value to a curve that the studio plots over time.
     *
     * @param curve name of the curve
     * @param value value in this cycle, in a unit of your choice
     */
    public final void plot(String curve, double value) {
        runtime.telemetry().plot(curve, value);
    }

    /**
     * Shows the robot's estimated pose in the studio.
     *
     * @param x metres from the centre towards the opponents' goal
     * @param y metres to the left of the centre
     * @param headingDegrees heading of the torso; 0 is towards the opponents' goal, positive is left
     */
    public final void publishPose(double x, double y, double headingDegrees) {
        runtime.telemetry().locate(new Pose2d(x, y, headingDegrees));
    }
}
