package org.robonewbie.agent;

import java.io.IOException;
import java.io.PrintStream;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.robonewbie.agent.log.StudentCode;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;

/** The life of one robot in a game: receives each message and answers it exactly once. */
final class Session implements AutoCloseable {

    private static final double CYCLE_MILLISECONDS = 20;
    private static final double WARM_UP_SECONDS = 1;
    private static final double SECONDS_BETWEEN_REPORTS = 10;

    private final NaoBody body;
    private final Walk walk;
    private final LocalFieldView fieldView;
    private final MessagePort port;
    private final OptionalDouble lifeSeconds;
    private final double bornSeconds;
    private final PrintStream out;
    private boolean answered = true;
    private boolean broken;
    private boolean over;
    private boolean closed;
    private long cycles;
    private long lateCycles;
    private long receivedNanos;
    private Supplier<String> slowPlace = () -> StudentCode.place().orElse("");

    Session(
            NaoBody body,
            Walk walk,
            LocalFieldView fieldView,
            MessagePort port,
            OptionalDouble lifeSeconds,
            PrintStream out) {
        this.body = body;
        this.walk = walk;
        this.fieldView = fieldView;
        this.port = port;
        this.lifeSeconds = lifeSeconds;
        this.bornSeconds = body.getTime();
        this.out = out;
    }

    /** Finds somebody who knows where the robot's program spent its time in a cycle that came late. */
    void askWhenLate(Supplier<String> place) {
        slowPlace = place;
    }

    /** Waits for the next message; false if the game is over for this robot. */
    boolean sense() {
        if (closed) {
            body.mistakes().report("closed", () -> "The robot has left the game: sense() was called after close().");
            return false;
        }
        if (!answered) {
            act();
        }
        over = broken || isOver() || !receive();
        return !over;
    }

    private boolean receive() {
        try {
            boolean received = port.receive();
            if (received) {
                perceive(port.message());
            }
            return received;
        } catch (IOException failure) {
            report(failure);
            return false;
        }
    }

    /** Sends the answer to the last message, once. */
    void act() {
        if (answered) {
            return;
        }
        answered = true;
        if (body.commands().isBeaming() && body.isBeamAllowed()) {
            fieldView.forget();
            walk.reset();
            body.senses().falls().reset();
        }
        walk.update(body.senses().torso());
        body.thoughts().act(walk);
        MessageBuffer commands = body.commands().write();
        try {
            checkPunctuality();
            port.send(commands);
        } catch (IOException failure) {
            report(failure);
        }
    }

    /** Sends the answer as {@link #act}, and reports it if there is no message to answer. */
    void actOnce() {
        if (answered && !over && !closed) {
            body.mistakes()
                    .report(
                            "act twice",
                            () -> "act() sends nothing, since the last message is answered already:"
                                    + " call sense() before each act().");
        }
        act();
    }

    /** Whether the last message still waits for its answer. */
    boolean isAnswerDue() {
        return !answered;
    }

    /** Whether the connection broke in the middle of the game. */
    boolean isBroken() {
        return broken;
    }

    /** Counts the messages so far. */
    long cycles() {
        return cycles;
    }

    @Override
    public void close() {
        closed = true;
        port.close();
    }

    private void perceive(PerceptorMessage message) {
        receivedNanos = System.nanoTime();
        cycles++;
        answered = false;
        body.accept(message);
        fieldView.setIdentity(body.getTeam(), body.getNumber(), body.getTeamSide());
        fieldView.setTime(body.getTime());
        if (message.vision().isPresent()) {
            double yaw = body.getJointAngle(Joint.NECK_YAW);
            double pitch = body.getJointAngle(Joint.NECK_PITCH);
            fieldView.see(message.vision().get(), yaw, pitch);
            body.thoughts().believe(fieldView);
        }
    }

    private boolean isOver() {
        return lifeSeconds.isPresent() && body.getTime() - bornSeconds >= lifeSeconds.getAsDouble() - 1e-6;
    }

    private void checkPunctuality() throws IOException {
        double milliseconds = (System.nanoTime() - receivedNanos) / 1e6;
        if (milliseconds > CYCLE_MILLISECONDS && port.isLate()) {
            lateCycles++;
            body.log().warning("cycle %d came late: it took %.0f ms", cycles, milliseconds);
            if (body.getTime() - bornSeconds > WARM_UP_SECONDS) {
                reportLate(milliseconds);
            }
        }
    }

    /** Reports a late cycle; of the same line in the program only one in ten seconds. */
    private void reportLate(double milliseconds) {
        long period = (long) (body.getTime() / SECONDS_BETWEEN_REPORTS);
        body.mistakes()
                .reportAt(
                        slowPlace.get(),
                        "late in period " + period,
                        () -> String.format(
                                Locale.ROOT,
                                "Cycle %d took %.0f ms, but the simulator waits only 20 ms and has gone on; compute less"
                                        + " in a cycle, and log instead of printing. Late cycles so far: %d.",
                                cycles,
                                milliseconds,
                                lateCycles));
    }

    private void report(IOException failure) {
        if (!broken) {
            broken = true;
            out.println("The connection to the simulator is lost: " + failure.getMessage());
        }
    }
}
