package org.robonewbie.agent;

import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.log.Logger;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.agent.motion.Motors;
import org.robonewbie.agent.perception.BodyPosition;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.Heard;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.Vision;

/**
 * The hardware of the robot: getters are its sensors as of the last message, setters are its motors and its loudspeaker for the
 * next. A value that the robot cannot use is ignored or replaced by the nearest one that it can, and reported once.
 *
 * <p>Units are degrees, metres, seconds and newtons. Vectors have x forward, y to the left and z up, seen from the robot.
 * (SimSpark's own messages have x to the right and y forward; they are turned on reception.)
 *
 * <p>What is commanded now shows its effect in the message after the next, since one message is always under way.
 */
public class NaoBody extends Sketchbook {

    private final Senses senses = new Senses();
    private final Thoughts thoughts = new Thoughts(senses);
    private final Commands commands;
    private final Motors motors = new Motors();
    private final Mistakes mistakes;
    private final Logger log;

    NaoBody(Logger log, Mistakes mistakes) {
        this.log = log;
        this.mistakes = mistakes;
        this.commands = new Commands(senses, motors, mistakes);
        log.setListener(thoughts::log);
        mistakes.setListener(thoughts::log);
    }

    @Override
    final Thoughts thoughts() {
        return thoughts;
    }

    Senses senses() {
        return senses;
    }

    Commands commands() {
        return commands;
    }

    Mistakes mistakes() {
        return mistakes;
    }

    /**
     * Gives access to what the robot logs.
     *
     * @return the log, printed when the run is over
     */
    public final Logger log() {
        return log;
    }

    /**
     * Gives access to the motors, for movements that are classes of their own.
     *
     * @return the motors of all joints
     */
    public final Motors motors() {
        return motors;
    }

    /**
     * Reads the clock.
     *
     * @return simulated seconds since the simulator was started; grows by 0.02 in each cycle
     */
    public final double getTime() {
        return senses.seconds();
    }

    /**
     * Reads the sensor of a joint.
     *
     * @param joint the joint
     * @return its angle in degrees, normally within the joint's range; each cycle
     */
    public final double getJointAngle(Joint joint) {
        return motors.degrees(joint);
    }

    /**
     * Reads the gyroscope in the torso.
     *
     * @return turning speed in degrees per second: x is positive while the right side goes down, y while the robot bends
     *     forward, z while it turns left; each cycle
     */
    public final Vector3 getGyro() {
        return senses.torso().gyro();
    }

    /**
     * Reads the accelerometer in the torso.
     *
     * @return acceleration in m/s²: x forward, y left, z up; about (0, 0, 9.81) for a robot that stands still, with strong
     *     knocks while it walks; each cycle
     */
    public final Vector3 getAcceleration() {
        return senses.torso().acceleration();
    }

    /**
     * Reads the sensors in the left sole.
     *
     * @return where and how strong the ground presses; no force in the air; each cycle
     */
    public final FootPressure getLeftFootPressure() {
        return senses.leftFoot();
    }

    /**
     * Reads the sensors in the right sole.
     *
     * @return where and how strong the ground presses; no force in the air; each cycle
     */
    public final FootPressure getRightFootPressure() {
        return senses.rightFoot();
    }

    /**
     * Looks through the camera. {@code LocalFieldView} remembers what it sees and is easier to use.
     *
     * @return what the camera recognises, seen from the head as it is turned now; empty in two of three cycles
     */
    public final Optional<Vision> getVision() {
        return senses.message().vision();
    }

    /**
     * Listens.
     *
     * @return what other robots said, without the own words; mostly empty
     */
    public final List<Heard> getHeard() {
        return senses.heard();
    }

    /**
     * Asks the referee how the game stands.
     *
     * @return the play mode; the last one that this framework knows
     */
    public final PlayMode getPlayMode() {
        return senses.playMode();
    }

    /**
     * Asks the referee how long the game has lasted.
     *
     * @return seconds of play; does not grow before the kick-off
     */
    public final double getPlayTime() {
        return senses.playSeconds();
    }

    /**
     * Tells which half the own team defends.
     *
     * @return left until the referee has said something else
     */
    public final TeamSide getTeamSide() {
        return senses.side();
    }

    /**
     * Names the own team.
     *
     * @return the name
     */
    public final String getTeam() {
        return senses.team();
    }

    /**
     * Tells the number on the own shirt.
     *
     * @return 1 to 11; 0 before the robot has joined a game
     */
    public final int getNumber() {
        return senses.number();
    }

    /**
     * Counts the goals of the own team.
     *
     * @return at least 0
     */
    public final int getOwnScore() {
        return senses.score(senses.side());
    }

    /**
     * Counts the goals of the other team.
     *
     * @return at least 0
     */
    public final int getOpponentScore() {
        return senses.score(senses.side().opponent());
    }

    /**
     * Feels whether the robot lies on the ground, by the smoothed accelerometer: about half a second after it has fallen.
     *
     * @return whether the torso leans by more than 60 degrees
     */
    public final boolean isFallen() {
        return getBodyPosition().isFallen();
    }

    /**
     * Feels on which side the robot lies.
     *
     * @return upright, or back, front, left or right side
     */
    public final BodyPosition getBodyPosition() {
        return senses.falls().bodyPosition();
    }

    /**
     * Shows the last message as the simulator sent it, for the curious.
     *
     * @return an S-expression, or an empty text if the robot has no connection
     */
    public final String getRawMessage() {
        return senses.rawMessage();
    }

    /**
     * Lets a motor turn. It goes on until it gets another speed or target, or a motion starts, and stops at the end of the
     * joint's range.
     *
     * @param joint the joint
     * @param degreesPerSecond speed from -351.77 to 351.77; 0 stops and holds the joint
     */
    public final void setJointSpeed(Joint joint, double degreesPerSecond) {
        commands.setJointSpeed(joint, degreesPerSecond);
    }

    /**
     * Moves a joint to an angle as fast as it can and holds it there, until it gets another speed or target, or a motion
     * starts.
     *
     * @param joint the joint
     * @param degrees the angle, within the joint's range
     */
    public final void setJointAngle(Joint joint, double degrees) {
        commands.setJointAngle(joint, degrees, joint.maxDegreesPerSecond());
    }

    /**
     * Moves a joint to an angle and holds it there, until it gets another speed or target, or a motion starts.
     *
     * @param joint the joint
     * @param degrees the angle, within the joint's range
     * @param degreesPerSecond how fast it may move, above 0 and up to 351.77
     */
    public final void setJointAngle(Joint joint, double degrees, double degreesPerSecond) {
        commands.setJointAngle(joint, degrees, degreesPerSecond);
    }

    /**
     * Calls something over the field; robots up to 50 m away can hear it. There is room for one text in each cycle, the last one
     * counts.
     *
     * @param text 1 to 20 letters, digits and signs, without blanks, brackets, quotes and semicolons
     */
    public final void say(String text) {
        commands.say(text);
    }

    /**
     * Puts the robot somewhere on its own half. The referee allows it before a kick-off and after a goal.
     *
     * @param x metres from the centre towards the opponents' goal, so not above 0
     * @param y metres from the centre to the left
     * @param degrees direction to look to; 0 is towards the opponents' goal, positive is left
     */
    public final void beam(double x, double y, double degrees) {
        if (!isBeamAllowed()) {
            commands.reportBeamNotAllowed();
        }
        commands.beam(x, y, degrees);
    }

    /**
     * Puts the robot somewhere on its own half. The referee allows it before a kick-off and after a goal.
     *
     * @param pose where to stand
     */
    public final void beam(StartPose pose) {
        beam(pose.x(), pose.y(), pose.degrees());
    }

    /**
     * Tells whether the referee allows the robot to be beamed now.
     *
     * @return whether the game waits for a kick-off or a goal was just scored
     */
    public final boolean isBeamAllowed() {
        return switch (getPlayMode()) {
            case BEFORE_KICK_OFF, GOAL_LEFT, GOAL_RIGHT -> true;
            default -> false;
        };
    }

    /** Takes in a message. */
    void accept(PerceptorMessage message) {
        senses.accept(message);
        for (Joint joint : Senses.JOINTS) {
            motors.sense(joint, message.jointAngles().degreesOr(joint, Double.NaN));
        }
        log.setTime(senses.seconds());
        mistakes.setTime(senses.seconds());
    }
}
