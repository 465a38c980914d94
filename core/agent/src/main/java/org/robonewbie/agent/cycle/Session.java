package org.robonewbie.agent.cycle;

import java.io.IOException;
import java.util.OptionalDouble;

/** Session of one robot in a game: each message is received, processed and answered exactly once. */
public final class Session implements AutoCloseable {

    private final RobotRuntime robot;
    private final MessagePort port;
    private final OptionalDouble lifeSeconds;
    private final CycleWatch watch;
    private final double bornSeconds;
    private boolean sensed = true;
    private boolean answered = true;
    private boolean senseOmitted;
    private boolean broken;
    private boolean left;
    private boolean over;
    private boolean closed;

    /**
     * Starts the session.
     *
     * @param robot processes and answers the messages
     * @param port source of messages
     * @param lifeSeconds simulated seconds until the robot leaves; empty if the simulator ends the game
     * @param watch notified when the robot's program starts and stops running within a cycle
     */
    public Session(RobotRuntime robot, MessagePort port, OptionalDouble lifeSeconds, CycleWatch watch) {
        this.robot = robot;
        this.port = port;
        this.lifeSeconds = lifeSeconds;
        this.watch = watch;
        this.bornSeconds = robot.sensors().seconds();
    }

    /**
     * Completes and reports any steps that the program omitted in the last cycle, and then waits for the next message.
     *
     * @return false if the game is over for this robot
     */
    public boolean next() {
        completeOmittedSteps();
        boolean received = receive();
        if (received && senseOmitted) {
            sense();
        }
        return received;
    }

    /**
     * Waits for the next message and reads all sensors, for programs that run the cycle themselves. An unanswered message is
     * answered first.
     *
     * @return false if the game is over for this robot
     */
    public boolean senseNext() {
        if (closed) {
            robot.diagnostics()
                    .report("closed", () -> "The robot has left the game: sense() was called after close().");
            return false;
        }
        complete();
        boolean received = receive();
        sense();
        return received;
    }

    /** Reads all sensors from the last message; has no effect when called again. */
    public void sense() {
        if (!sensed) {
            sensed = true;
            robot.perceive(port.message());
            watch.thinkBegins();
        }
    }

    /** Answers the last message; has no effect when called again. */
    public void act() {
        if (answered) {
            return;
        }
        answered = true;
        watch.thinkEnds();
        try {
            port.send(robot.act());
        } catch (IOException failure) {
            reportBroken(failure);
        }
        watch.thinkResumes();
    }

    /** Answers like {@link #act}, but reports the call if there is no message to answer. */
    public void actOnce() {
        if (answered && !over && !closed) {
            robot.diagnostics()
                    .report(
                            "act twice",
                            () -> "act() has no effect: the last message has already been answered;"
                                    + " call sense() before each act().");
        }
        act();
    }

    /** Completes the cycle after a step of the program has failed. */
    public void complete() {
        sense();
        act();
    }

    /** Leaves the game after the current cycle. */
    public void leave() {
        left = true;
    }

    /** {@return whether the connection broke in the middle of the game} */
    public boolean isBroken() {
        return broken;
    }

    @Override
    public void close() {
        closed = true;
        watch.thinkEnds();
        port.close();
    }

    private void completeOmittedSteps() {
        if (!sensed) {
            senseOmitted = true;
            sense();
            robot.diagnostics()
                    .reportAt("", "sense", () -> "sense() did not call super.sense(); the framework did it instead.");
        }
        if (!answered) {
            robot.diagnostics()
                    .reportAt("", "act", () -> "act() did not call super.act(); the framework did it instead.");
        }
        complete();
    }

    private boolean receive() {
        watch.thinkEnds();
        over = left || broken || isTimeOver() || !hasReceived();
        sensed = over;
        answered = over;
        return !over;
    }

    private boolean hasReceived() {
        try {
            return port.receive();
        } catch (IOException failure) {
            reportBroken(failure);
            return false;
        }
    }

    private boolean isTimeOver() {
        return lifeSeconds.isPresent() && robot.sensors().seconds() - bornSeconds >= lifeSeconds.getAsDouble() - 1e-6;
    }

    private void reportBroken(IOException failure) {
        if (!broken) {
            broken = true;
            System.err.println("Lost the connection to the simulator: " + failure.getMessage());
        }
    }
}
