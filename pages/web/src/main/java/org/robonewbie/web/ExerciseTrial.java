package org.robonewbie.web;

import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.Supplier;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.pagejvm.EndlessLoop;
import org.robonewbie.pagejvm.ProgramEnd;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.trial.ChallengeTrial;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.TrialListener;

/** One trial of an exercise, graded in the same way as by {@code robonewbie grade}. The user cannot move the robots or the ball. */
final class ExerciseTrial implements SteppedWorld {

    private final Task task;
    private Optional<ChallengeTrial> played = Optional.empty();
    private Optional<Score> failure = Optional.empty();
    private boolean stuck;
    private long cycles;

    /**
     * Sets up the scene and lets the robots join.
     *
     * @param exercise the exercise
     * @param seed random seed
     * @param student creates a robot that runs the student's program; called once per robot
     * @param recording destination of the recording
     */
    ExerciseTrial(Exercise exercise, long seed, Supplier<? extends Controller> student, RecordingTarget recording) {
        task = exercise.task().get();
        attempt(() -> played = Optional.of(new ChallengeTrial(
                task, exercise.seconds(), seed, RobotStart.TEAM, student, TrialListener.NONE, recording)));
    }

    private void attempt(Runnable command) {
        try {
            command.run();
        } catch (EndlessLoop loop) {
            stuck = true;
            failure = Optional.of(Performance.ofEndlessStep("", Optional.of(loop.place())));
        } catch (ProgramEnd end) {
            failure = Optional.of(Performance.ofExit(String.valueOf(end.exitCode())));
        } catch (RuntimeException | Error thrown) {
            failure = Optional.of(Performance.ofMistake(thrown));
        }
    }

    /** {@return whether the trial has started; false if the program failed before the start} */
    boolean isStarted() {
        return played.isPresent();
    }

    /** {@return whether the program is stuck in an infinite loop, which makes further trials pointless} */
    boolean isStuck() {
        return stuck;
    }

    Score score() {
        return failure.orElseGet(task::score);
    }

    @Override
    public void cycle() {
        cycles++;
        attempt(trial()::step);
    }

    @Override
    public boolean isOver() {
        return failure.isPresent() || trial().isOver();
    }

    @Override
    public long cycles() {
        return cycles;
    }

    @Override
    public WorldSnapshot snapshot(boolean paused, double speed) {
        return trial().trial().snapshot(paused, speed);
    }

    private ChallengeTrial trial() {
        return played.orElseThrow();
    }

    @Override
    public void order(Order order) {
        // The user cannot change a graded trial.
    }

    @Override
    public List<AgentMessages> messages(IntPredicate robots) {
        return List.of();
    }
}
