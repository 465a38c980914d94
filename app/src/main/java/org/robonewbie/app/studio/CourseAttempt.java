package org.robonewbie.app.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.app.program.GuestProcess;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.studio.course.Attempt;
import org.robonewbie.studio.course.Attempt.State;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.guest.GuestDoor;
import org.robonewbie.trial.watch.WatchedTrial;

/**
 * Trials of one exercise, one seed after the other, under the eyes of the student. The program runs in a process of its own, or
 * the student starts it, so what it does wrong does no harm to the studio.
 */
final class CourseAttempt implements AutoCloseable {

    private static final double SECONDS_OF_PATIENCE = 20;

    private final long id;
    private final Exercise exercise;
    private final String program;
    private final int trials;
    private final Path folder;
    private final GuestDoor door;
    private final Consumer<SimulationControl> screen;
    private final Consumer<Attempt> complete;
    private final List<Attempt.Judged> judged = new ArrayList<>();
    private final List<Controller> guests = new ArrayList<>();
    private final List<GuestProcess> processes = new ArrayList<>();
    private State state = State.WAITING;
    private WatchedTrial trial = new WatchedTrial();
    private boolean closed;

    private CourseAttempt(
            long id,
            Exercise exercise,
            String program,
            int trials,
            Path folder,
            GuestDoor door,
            Consumer<SimulationControl> screen,
            Consumer<Attempt> complete) {
        this.id = id;
        this.exercise = exercise;
        this.program = program;
        this.trials = trials;
        this.folder = folder;
        this.door = door;
        this.screen = screen;
        this.complete = complete;
    }

    /**
     * Begins with the first trial.
     *
     * @param id number of the attempt
     * @param program a Java file or class; empty for an agent that the student starts
     * @param folder where the program runs
     * @param screen shows each trial
     * @param complete hears of the attempt when all trials are judged
     * @throws IOException if no port is free
     */
    static CourseAttempt begin(
            long id,
            Exercise exercise,
            String program,
            int trials,
            Path folder,
            Consumer<SimulationControl> screen,
            Consumer<Attempt> complete)
            throws IOException {
        boolean own = program.isEmpty();
        GuestDoor door = own ? usualDoor() : GuestDoor.open(0, SECONDS_OF_PATIENCE);
        CourseAttempt attempt = new CourseAttempt(id, exercise, program, trials, folder, door, screen, complete);
        Thread thread = new Thread(attempt::tryAll, "exercise");
        thread.setDaemon(true);
        thread.start();
        return attempt;
    }

    /**
     * Students' own agents connect to the same port each time if possible; their debuggers may hold them as long as they like.
     */
    private static GuestDoor usualDoor() throws IOException {
        try {
            return GuestDoor.open(LocalCourseService.USUAL_PORT, 0);
        } catch (IOException inUse) {
            return GuestDoor.open(0, 0);
        }
    }

    private void tryAll() {
        for (int seed = 1; seed <= trials && beginTrial(seed); seed++) {
            Score score = Performance.of(exercise, seed, this::nextRobot, Optional.empty(), trial);
            end(seed, score);
        }
        Attempt result = state();
        if (result.judged().size() == trials) {
            complete.accept(result);
        }
        finish();
    }

    private synchronized boolean beginTrial(long seed) {
        if (closed) {
            return false;
        }
        state = State.WAITING;
        trial = trial.next(new TrialLabel(exercise.name(), id, seed));
        screen.accept(trial);
        return true;
    }

    private Controller nextRobot() {
        Optional<GuestProcess> process = program.isEmpty() ? Optional.empty() : Optional.of(startProcess());
        Controller guest = door.await(
                () -> !isClosed() && process.map(GuestProcess::isRunning).orElse(true));
        return arrived(guest);
    }

    private synchronized GuestProcess startProcess() {
        GuestProcess process = GuestProcess.start(exercise, program, door.port(), folder);
        processes.add(process);
        return process;
    }

    private synchronized Controller arrived(Controller guest) {
        guests.add(guest);
        state = State.RUNNING;
        return guest;
    }

    private synchronized void end(long seed, Score score) {
        trial.leave();
        sendAway();
        if (!closed) {
            judged.add(new Attempt.Judged(seed, score.passed(), score.points(), score.finding(), score.hint()));
        }
    }

    private synchronized void finish() {
        state = State.OVER;
        door.close();
        notifyAll();
    }

    /** Waits until all trials are over. */
    synchronized void awaitEnd() throws InterruptedException {
        while (state != State.OVER) {
            wait();
        }
    }

    private synchronized boolean isClosed() {
        return closed;
    }

    /** The present state of the attempt. */
    synchronized Attempt state() {
        double points =
                judged.stream().mapToInt(Attempt.Judged::points).average().orElse(0);
        boolean passed = judged.size() == trials && judged.stream().allMatch(Attempt.Judged::passed);
        String output =
                processes.isEmpty() ? "" : processes.get(processes.size() - 1).output();
        return new Attempt(id, state, exercise.name(), program, door.port(), trials, judged, points, passed, output);
    }

    private void sendAway() {
        guests.forEach(Controller::close);
        guests.clear();
        processes.forEach(GuestProcess::close);
    }

    /** Ends the attempt, whatever it is at. */
    @Override
    public synchronized void close() {
        closed = true;
        door.close();
        sendAway();
        trial.leave();
    }
}
