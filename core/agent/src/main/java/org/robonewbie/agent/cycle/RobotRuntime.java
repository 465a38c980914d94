package org.robonewbie.agent.cycle;

import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.log.RunLog;
import org.robonewbie.agent.motion.LookAround;
import org.robonewbie.agent.motion.MotionSequencer;
import org.robonewbie.agent.perception.FieldMemory;
import org.robonewbie.agent.walk.WalkController;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/**
 * The components of one robot, wired together: they receive a perceptor message and return the commands in response.
 *
 * <pre>{@code
 * RobotRuntime robot = new RobotRuntime("Walker");
 * robot.perceive(message);
 * robot.motions().start("wave");
 * List<EffectorCommand> answer = robot.act();
 * }</pre>
 *
 * <p>Students' programs access them through {@code Robot}, {@code Motions}, {@code Walk}, {@code LocalFieldView} and
 * {@code Logger}.
 */
public final class RobotRuntime {

    private final RunLog log;
    private final Diagnostics diagnostics = new Diagnostics(System.err);
    private final SensorState sensors = new SensorState();
    private final Motors motors = new Motors(sensors.joints());
    private final LookAround lookAround = new LookAround(motors);
    private final Commands commands = new Commands(sensors, motors, diagnostics, this::turningMotion);
    private final MotionSequencer motions;
    private final WalkController walk;
    private final FieldMemory fieldView = new FieldMemory(diagnostics);
    private final TelemetryPublisher telemetry = new TelemetryPublisher(sensors);

    /**
     * Creates a robot without sensor readings.
     *
     * @param name name of the robot, for the heading of its log
     */
    public RobotRuntime(String name) {
        log = new RunLog(name);
        motions = new MotionSequencer(motors, MotionFiles.library(), diagnostics, sensors::bodyPosition);
        walk = new WalkController(motors, motions, diagnostics, sensors::bodyPosition);
        log.setListener(telemetry::publish);
        log.setPatternListener(advice -> diagnostics.report("log pattern", advice));
        diagnostics.setListener(telemetry::publish);
    }

    /**
     * Processes a message: updates sensors, clocks and the field view.
     *
     * @param message the perceptors' readings
     */
    public void perceive(PerceptorMessage message) {
        sense(message);
        fieldView.setIdentity(sensors.team(), sensors.number(), sensors.side());
        fieldView.setTime(sensors.seconds());
        if (message.vision().isPresent()) {
            double yaw = sensors.joints().degrees(Joint.NECK_YAW);
            double pitch = sensors.joints().degrees(Joint.NECK_PITCH);
            fieldView.see(message.vision().get(), yaw, pitch);
            telemetry.publishBelief(fieldView);
        }
    }

    /**
     * Processes a message without updating the field view, for use before the robot has joined a game.
     *
     * @param message the perceptors' readings
     */
    public void sense(PerceptorMessage message) {
        sensors.accept(message);
        log.setTime(sensors.seconds());
        diagnostics.setTime(sensors.seconds());
    }

    /**
     * Advances the walk and the motions by one cycle.
     *
     * @return the robot's commands for this cycle, with {@code Synchronise} at the end
     */
    public List<EffectorCommand> act() {
        if (commands.isBeaming() && sensors.isBeamAllowed()) {
            discardPose();
        }
        walk.update(sensors.torso(), sensors.leftFoot(), sensors.rightFoot());
        telemetry.publishActions(walk);
        return commands.take();
    }

    /** Stops all motions and clears the field view, for a robot that continues from a restored world. */
    public void startOver() {
        motions.reset();
        discardPose();
    }

    private Optional<String> turningMotion(Joint joint) {
        return motions.turning(joint);
    }

    /** Discards the known position and posture of the robot, which are no longer valid. */
    private void discardPose() {
        fieldView.forget();
        walk.reset();
        sensors.falls().reset();
    }

    /** {@return the log} */
    public RunLog log() {
        return log;
    }

    /** {@return the diagnostics of the program} */
    public Diagnostics diagnostics() {
        return diagnostics;
    }

    /** {@return the last readings of all sensors} */
    public SensorState sensors() {
        return sensors;
    }

    /** {@return the head scan} */
    public LookAround lookAround() {
        return lookAround;
    }

    /** {@return the commands of this cycle} */
    public Commands commands() {
        return commands;
    }

    /** {@return the keyframe motions} */
    public MotionSequencer motions() {
        return motions;
    }

    /** {@return the walk} */
    public WalkController walk() {
        return walk;
    }

    /** {@return the memory of the field} */
    public FieldMemory fieldView() {
        return fieldView;
    }

    /** {@return the telemetry publisher} */
    public TelemetryPublisher telemetry() {
        return telemetry;
    }
}
