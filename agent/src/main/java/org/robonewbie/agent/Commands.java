package org.robonewbie.agent;

import java.util.Locale;
import java.util.Optional;
import org.robonewbie.agent.log.Mistakes;
import org.robonewbie.agent.motion.Motors;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;

/** What the robot is told to do in this cycle; checks it, and turns it into a message for the simulator. */
final class Commands {

    private static final String SPEED_IS_A_SIZE = "Give a speed above 0; the angle decides on the direction.";

    private final Senses senses;
    private final Motors motors;
    private final Mistakes mistakes;
    private final boolean[] turning = new boolean[Joint.COUNT];
    private final boolean[] atEnd = new boolean[Joint.COUNT];
    private final MessageBuffer message = new MessageBuffer();
    private final EffectorMessageWriter writer = new EffectorMessageWriter(message);
    private Optional<String> text = Optional.empty();
    private Optional<StartPose> pose = Optional.empty();

    Commands(Senses senses, Motors motors, Mistakes mistakes) {
        this.senses = senses;
        this.motors = motors;
        this.mistakes = mistakes;
    }

    void setJointSpeed(Joint joint, double speed) {
        if (Double.isNaN(speed)) {
            mistakes.report(
                    "speed NaN " + joint,
                    () -> "Joint speed NaN for " + joint + " is ignored. Was something divided by zero?");
            return;
        }
        double most = joint.maxDegreesPerSecond();
        if (Math.abs(speed) > most) {
            mistakes.report(
                    "speed " + joint,
                    () -> format(
                            "Joint speed %.4g for %s is more than its motor can do; it turns with %.2f degrees per second.",
                            speed, joint, most));
        }
        double possible = Math.max(-most, Math.min(most, speed));
        if (motors.leavesRange(joint, possible) && !atEnd[joint.ordinal()]) {
            atEnd[joint.ordinal()] = true;
            mistakes.report("end of range " + joint, () -> endOfRange(joint));
        }
        motors.setSpeed(joint, possible);
    }

    void setJointAngle(Joint joint, double degrees, double speed) {
        if (!Double.isFinite(degrees) || !(speed > 0)) {
            mistakes.report(
                    "angle " + joint + (speed <= 0),
                    () -> format(
                            "Joint angle %s with speed %s for %s is ignored. %s",
                            degrees, speed, joint, speed <= 0 ? SPEED_IS_A_SIZE : "Was something divided by zero?"));
            return;
        }
        if (joint.clampDegrees(degrees) != degrees) {
            mistakes.report(
                    "range " + joint,
                    () -> format(
                            "Joint angle %s for %s is beyond its range of %.0f to %.0f degrees; it goes to the end of"
                                    + " the range.",
                            degrees, joint, joint.minDegrees(), joint.maxDegrees()));
        }
        motors.setTarget(joint, degrees, speed);
    }

    void say(String newText) {
        try {
            new EffectorMessageWriter(new MessageBuffer()).say(newText);
            text = Optional.of(newText);
        } catch (IllegalArgumentException unspeakable) {
            mistakes.report("say", () -> String.valueOf(unspeakable.getMessage()));
        }
    }

    void beam(double x, double y, double degrees) {
        if (!Double.isFinite(x + y + degrees)) {
            mistakes.report(
                    "beam NaN",
                    () -> format("Beam to %s, %s, %s is ignored. Was something divided by zero?", x, y, degrees));
            return;
        }
        pose = Optional.of(new StartPose(x, y, degrees));
    }

    /** Whether the robot will be put somewhere else by the next message. */
    boolean isBeaming() {
        return pose.isPresent();
    }

    void reportBeamNotAllowed() {
        mistakes.report(
                "beam not allowed",
                () -> "The referee does not allow a beam in play mode " + senses.playMode()
                        + ", only before a kick-off and after a goal: ask isBeamAllowed() first.");
    }

    /**
     * Ends the cycle: fixes the speeds, writes all commands, and forgets those that count only once.
     *
     * @return the message, which changes with the next call
     */
    MessageBuffer write() {
        motors.endCycle();
        message.clear();
        for (Joint joint : Senses.JOINTS) {
            writeSpeed(joint);
        }
        if (pose.isPresent()) {
            writer.beam(pose.get().x(), pose.get().y(), pose.get().degrees());
        }
        if (text.isPresent()) {
            writer.say(text.get());
        }
        writer.synchronise();
        pose = Optional.empty();
        text = Optional.empty();
        return message;
    }

    /** A motor goes on with its speed by itself, so a resting one need not be told so again. */
    private void writeSpeed(Joint joint) {
        double speed = motors.sentDegreesPerSecond(joint);
        if (speed != 0 || turning[joint.ordinal()]) {
            writer.hingeSpeed(joint, Math.toRadians(speed));
        }
        turning[joint.ordinal()] = speed != 0;
        if (motors.isStopped(joint) && !atEnd[joint.ordinal()]) {
            atEnd[joint.ordinal()] = true;
            mistakes.reportAt("", "end of range " + joint, () -> endOfRange(joint));
        }
    }

    private String endOfRange(Joint joint) {
        return format(
                "%s has reached the end of its range (%.0f to %.0f degrees) at %.1f and stops there; set another speed.",
                joint, joint.minDegrees(), joint.maxDegrees(), motors.degrees(joint));
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
