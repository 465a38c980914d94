package org.robonewbie.app.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.grading.ProcessGrader;
import org.robonewbie.programs.process.GuestDoor;
import org.robonewbie.programs.process.RobotProcess;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.studio.course.Attempt;
import org.robonewbie.studio.course.Attempt.State;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.watch.WatchedTrial;

/**
 * Trials of one exercise with consecutive seeds, shown to the student. The program runs in its own process, or the student starts it, so
 * that its failures cannot harm the studio.
 */
final class CourseAttempt implements AutoCloseable {

    private final long id;
    private final Exercise exercise;
    private final String program;
    private final int trials;
    private final Optional<GuestDoor> door;
    private final Optional<RobotProcess> student;
    private final Consumer<SimulationControl> screen;
    private final Consumer<Attempt> complete;
    private final List<Attempt.Judged> judged = new ArrayList<>();
    private final List<Controller> guests = new ArrayList<>();
    private State state = State.WAITING;
    private WatchedTrial trial = new WatchedTrial();
    private boolean closed;

    private CourseAttempt(
            long id,
            Exercise exercise,
            String program,
            int trials,
            Optional<GuestDoor> door,
            Optional<RobotProcess> student,
            Consumer<SimulationControl> screen,
            Consumer<Attempt> complete) {
        this.id = id;
        this.exercise = exercise;
        this.program = program;
        this.trials = trials;
        this.door = door;
        this.student = student;
        this.screen = screen;
        this.complete = complete;
    }

    /**
     * Starts the first trial.
     *
     * @param id number of the attempt
     * @param program a Java file or class; empty for an agent that the student starts
     * @param folder working directory of the program
     * @param screen shows each trial
     * @param complete receives the attempt when all trials have been judged
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
        Optional<GuestDoor> door = own ? Optional.of(defaultDoor()) : Optional.empty();
        Optional<RobotProcess> student = own ? Optional.empty() : Optional.of(start(program, folder));
        CourseAttempt attempt = new CourseAttempt(id, exercise, program, trials, door, student, screen, complete);
        Thread thread = new Thread(attempt::tryAll, "exercise");
        thread.setDaemon(true);
        thread.start();
        return attempt;
    }

    /** Opens the same port each time if possible, without a timeout, since the student's agent may be held by a debugger. */
    private static GuestDoor defaultDoor() throws IOException {
        try {
            return GuestDoor.open(LocalCourseService.DEFAULT_PORT);
        } catch (IOException inUse) {
            return GuestDoor.open(0);
        }
    }

    private static RobotProcess start(String program, Path folder) throws IOException {
        RobotProcess.Request request = new RobotProcess.Request(program, List.of(folder), folder, false);
        return new RobotProcess(request, Sandbox.none("a program of its own author"), line -> {});
    }

    private void tryAll() {
        for (int seed = 1; seed <= trials && beginTrial(seed); seed++) {
            end(seed, play(seed));
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

    private Score play(long seed) {
        if (student.isEmpty()) {
            return Performance.of(exercise, seed, this::nextRobot, Optional.empty(), trial);
        }
        try {
            begins();
            return ProcessGrader.trial(exercise, seed, student.get(), Optional.empty(), trial);
        } catch (IOException noPort) {
            return Score.failed(0, "There is no way to the program (" + noPort.getMessage() + ").", "");
        }
    }

    private Controller nextRobot() {
        return arrived(door.orElseThrow().await(() -> !isClosed()));
    }

    private synchronized void begins() {
        state = State.RUNNING;
    }

    private synchronized Controller arrived(Controller guest) {
        guests.add(guest);
        state = State.RUNNING;
        return guest;
    }

    private synchronized void end(long seed, Score score) {
        trial.leave();
        disconnect();
        if (!closed) {
            judged.add(new Attempt.Judged(seed, score.passed(), score.points(), score.finding(), score.hint()));
        }
    }

    private synchronized void finish() {
        state = State.OVER;
        door.ifPresent(GuestDoor::close);
        student.ifPresent(RobotProcess::close);
        notifyAll();
    }

    /** Waits until all trials have ended. */
    synchronized void awaitEnd() throws InterruptedException {
        while (state != State.OVER) {
            wait();
        }
    }

    private synchronized boolean isClosed() {
        return closed;
    }

    /** The current state of the attempt. */
    synchronized Attempt state() {
        double points =
                judged.stream().mapToInt(Attempt.Judged::points).average().orElse(0);
        boolean passed = judged.size() == trials && judged.stream().allMatch(Attempt.Judged::passed);
        int port = door.map(GuestDoor::port).orElse(0);
        String output = student.map(RobotProcess::output).orElse("");
        return new Attempt(id, state, exercise.name(), program, port, trials, judged, points, passed, output);
    }

    private void disconnect() {
        guests.forEach(Controller::close);
        guests.clear();
    }

    /** Ends the attempt in any state. */
    @Override
    public synchronized void close() {
        closed = true;
        door.ifPresent(GuestDoor::close);
        student.ifPresent(RobotProcess::close);
        disconnect();
        trial.leave();
    }
}
