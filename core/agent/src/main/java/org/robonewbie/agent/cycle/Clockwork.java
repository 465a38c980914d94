package org.robonewbie.agent.cycle;

import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.log.Mistakes;
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
 * All that is inside one robot, wired together: it takes in a perception, and gives the commands that answer it.
 *
 * <pre>{@code
 * Clockwork robot = new Clockwork("Walker");
 * robot.perceive(message);
 * robot.motions().start("wave");
 * List<EffectorCommand> answer = robot.act();
 * }</pre>
 *
 * <p>Programs of students see it through {@code Robot}, {@code Motions}, {@code Walk}, {@code LocalFieldView} and {@code Logger}.
 */
public final class Clockwork {

    private final RunLog log;
    private final Mistakes mistakes = new Mistakes(System.err);
    private final Senses senses = new Senses();
    private final Motors motors = new Motors(senses.joints());
    private final LookAround lookAround = new LookAround(motors);
    private final Commands commands = new Commands(senses, motors, mistakes, this::turningMotion);
    private final MotionSequencer motions;
    private final WalkController walk;
    private final FieldMemory fieldView = new FieldMemory(mistakes);
    private final TelemetryPublisher telemetry = new TelemetryPublisher(senses);

    /**
     * Creates a robot that has not sensed anything yet.
     *
     * @param name the robot's name, for the headline of its log
     */
    public Clockwork(String name) {
        log = new RunLog(name);
        motions = new MotionSequencer(motors, MotionFiles.library(), mistakes, senses::bodyPosition);
        walk = new WalkController(motors, motions, mistakes, senses::bodyPosition);
        log.setListener(telemetry::publish);
        log.setPatternListener(advice -> mistakes.report("log pattern", advice));
        mistakes.setListener(telemetry::publish);
    }

    /**
     * Takes in a message: sensors, clocks, and the view of the field.
     *
     * @param message what the robot senses
     */
    public void perceive(PerceptorMessage message) {
        sense(message);
        fieldView.setIdentity(senses.team(), senses.number(), senses.side());
        fieldView.setTime(senses.seconds());
        if (message.vision().isPresent()) {
            double yaw = senses.joints().degrees(Joint.NECK_YAW);
            double pitch = senses.joints().degrees(Joint.NECK_PITCH);
            fieldView.see(message.vision().get(), yaw, pitch);
            telemetry.publishBelief(fieldView);
        }
    }

    /**
     * Takes in a message without looking at the field, as long as the robot is not in the game yet.
     *
     * @param message what the robot senses
     */
    public void sense(PerceptorMessage message) {
        senses.accept(message);
        log.setTime(senses.seconds());
        mistakes.setTime(senses.seconds());
    }

    /**
     * Advances walk and motions by one cycle.
     *
     * @return what the robot does in this cycle, with {@code Synchronise} at the end
     */
    public List<EffectorCommand> act() {
        if (commands.isBeaming() && senses.isBeamAllowed()) {
            loseOrientation();
        }
        walk.update(senses.torso(), senses.leftFoot(), senses.rightFoot());
        telemetry.publishActions(walk);
        return commands.take();
    }

    /** Ends all motions and forgets the field, for a robot that goes on from another moment of the game. */
    public void startOver() {
        motions.reset();
        loseOrientation();
    }

    private Optional<String> turningMotion(Joint joint) {
        return motions.turning(joint);
    }

    /** What the robot knows of place and posture is no longer true. */
    private void loseOrientation() {
        fieldView.forget();
        walk.reset();
        senses.falls().reset();
    }

    /** {@return the log} */
    public RunLog log() {
        return log;
    }

    /** {@return the reports of mistakes} */
    public Mistakes mistakes() {
        return mistakes;
    }

    /** {@return the last readings of all sensors} */
    public Senses senses() {
        return senses;
    }

    /** {@return the head's movement to see more} */
    public LookAround lookAround() {
        return lookAround;
    }

    /** {@return what the robot is told to do in this cycle} */
    public Commands commands() {
        return commands;
    }

    /** {@return the motions by name} */
    public MotionSequencer motions() {
        return motions;
    }

    /** {@return the walk} */
    public WalkController walk() {
        return walk;
    }

    /** {@return what the robot remembers of the field} */
    public FieldMemory fieldView() {
        return fieldView;
    }

    /** {@return the publisher of what the robot thinks} */
    public TelemetryPublisher telemetry() {
        return telemetry;
    }
}
