package org.robonewbie.agent.cycle;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.T1Joint;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.RequestPass;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.protocol.effector.EffectorCommand.Synchronise;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.effector.LeagueMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;

/** Validated commands of the current cycle. */
public final class Commands {

    private static final String SPEED_ADVICE = "Use a speed above 0; the target angle determines the direction.";

    private final SensorState sensors;
    private final Motors motors;
    private final Diagnostics diagnostics;
    private final Function<Joint, Optional<String>> turningMotion;
    private final boolean[] atEnd = new boolean[Joint.COUNT];
    private Optional<Say> say = Optional.empty();
    private Optional<Beam> beam = Optional.empty();
    private boolean requestsPass;

    Commands(
            SensorState sensors,
            Motors motors,
            Diagnostics diagnostics,
            Function<Joint, Optional<String>> turningMotion) {
        this.sensors = sensors;
        this.motors = motors;
        this.diagnostics = diagnostics;
        this.turningMotion = turningMotion;
    }

    /**
     * Sets the speed of a joint.
     *
     * @param joint the joint
     * @param speed speed in degrees per second
     */
    public void setJointSpeed(Joint joint, double speed) {
        if (Double.isNaN(speed)) {
            diagnostics.reportSerious(
                    "speed NaN " + joint,
                    () -> "Joint speed NaN for " + joint + " is ignored. Was something divided by zero?");
            return;
        }
        reportConflict(joint);
        double most = joint.maxDegreesPerSecond();
        if (Math.abs(speed) > most) {
            diagnostics.report(
                    "speed " + joint,
                    () -> format(
                            "Joint speed %.4g for %s exceeds its maximum; it is limited to %.2f degrees per second.",
                            speed, joint, most));
        }
        double possible = Math.max(-most, Math.min(most, speed));
        if (motors.leavesRange(joint, possible) && !atEnd[joint.ordinal()]) {
            atEnd[joint.ordinal()] = true;
            diagnostics.report("end of range " + joint, () -> endOfRange(joint));
        }
        motors.setSpeed(joint, possible);
    }

    /**
     * Sets the target angle of a joint.
     *
     * @param joint the joint
     * @param degrees target angle in degrees
     * @param speed maximum speed in degrees per second
     */
    public void setJointAngle(Joint joint, double degrees, double speed) {
        if (!Double.isFinite(degrees) || !(speed > 0)) {
            diagnostics.reportSerious(
                    "angle " + joint + (speed <= 0),
                    () -> format(
                            "Joint angle %s with speed %s for %s is ignored. %s",
                            degrees, speed, joint, speed <= 0 ? SPEED_ADVICE : "Was something divided by zero?"));
            return;
        }
        reportConflict(joint);
        if (joint.clampDegrees(degrees) != degrees) {
            reportRange(joint, degrees, joint.minDegrees(), joint.maxDegrees());
        }
        motors.setTarget(joint, degrees, speed);
    }

    /**
     * Sets the target angle of a joint of a T1, with the gains with which the robot stands.
     *
     * @param joint the joint
     * @param degrees target angle in degrees
     */
    public void setJointAngle(T1Joint joint, double degrees) {
        if (isPossible(joint, degrees)) {
            sensors.ownJoints().ifPresent(joints -> joints.setTarget(joint, clamped(joint, degrees)));
        }
    }

    /**
     * Sets the target angle and the gains of a joint of a T1.
     *
     * @param joint the joint
     * @param degrees target angle in degrees
     * @param stiffness stiffness in newton metres per radian
     * @param damping damping in newton metres per radian per second
     */
    public void setJointAngle(T1Joint joint, double degrees, double stiffness, double damping) {
        if (!isPossible(joint, degrees + stiffness + damping)) {
            return;
        }
        double possibleStiffness = Math.max(0, Math.min(LeagueMessageWriter.MAX_STIFFNESS, stiffness));
        double possibleDamping = Math.max(0, Math.min(LeagueMessageWriter.MAX_DAMPING, damping));
        if (possibleStiffness != stiffness || possibleDamping != damping) {
            diagnostics.report(
                    "gains " + joint,
                    () -> format(
                            "Stiffness %.4g and damping %.4g of %s are limited to 0 to %.0f Nm/rad and 0 to %.0f Nm s/rad.",
                            stiffness,
                            damping,
                            joint,
                            LeagueMessageWriter.MAX_STIFFNESS,
                            LeagueMessageWriter.MAX_DAMPING));
        }
        sensors.ownJoints()
                .ifPresent(
                        joints -> joints.setTarget(joint, clamped(joint, degrees), possibleStiffness, possibleDamping));
    }

    private boolean isPossible(T1Joint joint, double numbers) {
        if (!Double.isFinite(numbers)) {
            diagnostics.reportSerious(
                    "angle " + joint,
                    () -> "A target for " + joint
                            + " that is not a finite number is ignored. Was something divided by zero?");
        }
        return Double.isFinite(numbers);
    }

    private double clamped(T1Joint joint, double degrees) {
        double possible = joint.clampDegrees(degrees);
        if (possible != degrees) {
            reportRange(joint, degrees, joint.minDegrees(), joint.maxDegrees());
        }
        return possible;
    }

    private void reportRange(Enum<?> joint, double degrees, double least, double most) {
        diagnostics.report(
                "range " + joint,
                () -> format(
                        "Joint angle %s for %s is beyond its range of %.0f to %.0f degrees; it is limited to the range.",
                        degrees, joint, least, most));
    }

    /**
     * Reports a command for a joint that a motion is moving. Commands for other joints, such as those of the head
     * during a kick, are allowed.
     */
    private void reportConflict(Joint joint) {
        turningMotion
                .apply(joint)
                .ifPresent(motion -> diagnostics.report(
                        "motion and command " + joint,
                        () -> format(
                                "%s is also moved by the motion \"%s\": it follows this command until the next motion starts."
                                        + " Wait for motions.isFinished(), or leave the joint to the motion.",
                                joint, motion)));
    }

    /**
     * Broadcasts a message.
     *
     * @param text 1 to 20 characters
     */
    public void say(String text) {
        try {
            new EffectorMessageWriter(new MessageBuffer()).say(text);
            say = Optional.of(new Say(text));
        } catch (IllegalArgumentException unspeakable) {
            diagnostics.report("say", () -> String.valueOf(unspeakable.getMessage()));
        }
    }

    /**
     * Beams the robot, and reports the call if the referee does not allow beaming.
     *
     * @param x metres from the centre towards the opponents' goal
     * @param y metres to the left of the centre
     * @param degrees heading in degrees
     */
    public void beam(double x, double y, double degrees) {
        if (!sensors.isBeamAllowed()) {
            diagnostics.report(
                    "beam not allowed",
                    () -> "The referee does not allow a beam in play mode " + sensors.playMode()
                            + ", only before a kick-off and after a goal: call isBeamAllowed() first.");
        }
        if (!Double.isFinite(x + y + degrees)) {
            diagnostics.report(
                    "beam NaN",
                    () -> format("Beam to %s, %s, %s is ignored. Was something divided by zero?", x, y, degrees));
            return;
        }
        beam = Optional.of(new Beam(new Pose2d(x, y, degrees)));
    }

    /** Requests pass mode. */
    public void requestPass() {
        requestsPass = true;
    }

    /** {@return whether the robot is beamed in this cycle} */
    public boolean isBeaming() {
        return beam.isPresent();
    }

    /**
     * Ends the cycle: calculates the final speeds and clears one-time commands.
     *
     * @return all commands, with {@code Synchronise} at the end
     */
    public List<EffectorCommand> take() {
        motors.endCycle();
        List<EffectorCommand> commands = new ArrayList<>();
        for (Joint joint : SensorState.JOINTS) {
            addSpeed(joint, commands);
        }
        beam.ifPresent(commands::add);
        say.ifPresent(commands::add);
        if (requestsPass) {
            commands.add(new RequestPass());
        }
        commands.add(new Synchronise());
        beam = Optional.empty();
        say = Optional.empty();
        requestsPass = false;
        return Collections.unmodifiableList(commands);
    }

    private void addSpeed(Joint joint, List<EffectorCommand> commands) {
        if (motors.needsCommand(joint)) {
            double speed = motors.sentDegreesPerSecond(joint);
            commands.add(new SetHingeSpeed(joint.effectorName(), PortableMath.toRadians(speed)));
        }
        if (motors.isStopped(joint) && !atEnd[joint.ordinal()]) {
            atEnd[joint.ordinal()] = true;
            diagnostics.reportAt("", "end of range " + joint, () -> endOfRange(joint));
        }
    }

    private String endOfRange(Joint joint) {
        return format(
                "%s has reached the end of its range (%.0f to %.0f degrees) at %.1f and stops there; set another speed.",
                joint, joint.minDegrees(), joint.maxDegrees(), sensors.joints().degrees(joint));
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
