package org.robonewbie.web;

import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.Supplier;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.Task;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.trial.TrialListener;
import org.robonewbie.trial.ChallengeTrial;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.pagejvm.EndlessLoop;
import org.robonewbie.pagejvm.ProgramEnd;

/** One trial of an exercise, which is judged as {@code robonewbie grade} does. Nobody can move robots or ball: it counts. */
final class ExerciseTrial implements SteppedWorld {

    private final Task task;
    private Optional<ChallengeTrial> played = Optional.empty();
    private Optional<Score> mistake = Optional.empty();
    private boolean stuck;
    private long cycles;

    /**
     * Sets the scene and lets the robots enter.
     *
     * @param exercise the exercise
     * @param seed start of all that is left to chance
     * @param student makes a robot with the student's program; asked once for each robot
     * @param recording where a recording goes
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
            mistake = Optional.of(Performance.ofEndlessStep("", Optional.of(loop.place())));
        } catch (ProgramEnd end) {
            mistake = Optional.of(Performance.ofExit(end.exitCode()));
        } catch (RuntimeException | Error thrown) {
            mistake = Optional.of(Performance.ofMistake(thrown));
        }
    }

    /** {@return whether there is something to be seen; not if the program has failed before} */
    boolean hasBegun() {
        return played.isPresent();
    }

    /** {@return whether the program does not come to the end of a step, so that further trials make no sense} */
    boolean isStuck() {
        return stuck;
    }

    /** {@return how the trial has ended} */
    Score score() {
        return mistake.orElseGet(task::score);
    }

    @Override
    public void cycle() {
        cycles++;
        attempt(trial()::step);
    }

    @Override
    public boolean isOver() {
        return mistake.isPresent() || trial().isOver();
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
        // a trial counts, so it goes its way
    }

    @Override
    public List<AgentMessages> messages(IntPredicate robots) {
        return List.of();
    }
}
