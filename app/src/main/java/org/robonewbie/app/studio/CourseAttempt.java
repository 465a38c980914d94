package org.robonewbie.app.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Grade.SeededScore;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.grading.ProcessGrader;
import org.robonewbie.exercises.service.CourseHost;
import org.robonewbie.exercises.service.CourseHost.State;
import org.robonewbie.exercises.service.CourseHost.Status;
import org.robonewbie.programs.process.GuestDoor;
import org.robonewbie.programs.process.RobotProcess;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.watch.WatchedTrial;

/**
 * Attempt at an exercise whose program runs in a separate process, started by the studio or the student, so that its
 * failures cannot harm the studio.
 */
final class CourseAttempt implements CourseHost.Attempt {

    /** Preferred port for students' own agents. */
    private static final int DEFAULT_PORT = 3110;

    private final long id;
    private final Exercise exercise;
    private final int trials;
    private final Optional<GuestDoor> door;
    private final Optional<RobotProcess> student;
    private final Consumer<SimulationControl> screen;
    private final Consumer<Grade> complete;
    private final List<SeededScore> judged = new ArrayList<>();
    private final List<Controller> guests = new ArrayList<>();
    private State state = State.WAITING;
    private WatchedTrial trial = new WatchedTrial();
    private boolean closed;
    private final Thread thread = new Thread(this::tryAll, "exercise");

    /**
     * Prepares the trials.
     *
     * @param program a Java file or class; empty for an agent that the student starts
     * @param folder working directory of the program
     * @param screen shows each trial
     * @param complete receives the grade when all trials have been judged
     * @throws IOException if no port is free
     */
    CourseAttempt(
            long id,
            Exercise exercise,
            String program,
            int trials,
            Path folder,
            Consumer<SimulationControl> screen,
            Consumer<Grade> complete)
            throws IOException {
        this.id = id;
        this.exercise = exercise;
        this.trials = trials;
        this.screen = screen;
        this.complete = complete;
        door = program.isEmpty() ? Optional.of(defaultDoor()) : Optional.empty();
        student = program.isEmpty() ? Optional.empty() : Optional.of(start(program, folder));
    }

    /** Starts the first trial. */
    void start() {
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Opens the same port each time if possible. The port has no timeout, because a debugger may suspend the student's
     * agent.
     */
    private static GuestDoor defaultDoor() throws IOException {
        try {
            return GuestDoor.open(DEFAULT_PORT);
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
        Grade result = status().grade();
        if (result.trials().size() == trials) {
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
            return Performance.of(exercise, seed, this::nextRobot, Optional.empty(), this::cycleEnded);
        }
        try {
            return ProcessGrader.trial(exercise, seed, student.get(), Optional.empty(), this::cycleEnded);
        } catch (IOException noPort) {
            return Score.failed(0, "The connection to the program cannot be opened (" + noPort.getMessage() + ").", "");
        }
    }

    private Controller nextRobot() {
        return arrived(door.orElseThrow().await(() -> !isClosed()));
    }

    private void cycleEnded(Trial running) {
        begins();
        trial.cycleEnded(running);
    }

    private synchronized void begins() {
        state = State.RUNNING;
    }

    private synchronized Controller arrived(Controller guest) {
        guests.add(guest);
        return guest;
    }

    private synchronized void end(long seed, Score score) {
        trial.leave();
        disconnect();
        if (!closed) {
            judged.add(new SeededScore(seed, score));
        }
    }

    private synchronized void finish() {
        state = State.OVER;
        door.ifPresent(GuestDoor::close);
        student.ifPresent(RobotProcess::close);
    }

    /** Waits until all trials have ended. */
    void awaitEnd() throws InterruptedException {
        thread.join();
    }

    private synchronized boolean isClosed() {
        return closed;
    }

    @Override
    public synchronized Status status() {
        int port = door.map(GuestDoor::port).orElse(0);
        String output = student.map(RobotProcess::output).orElse("");
        return new Status(state, port, new Grade(exercise.fullName(), judged), output);
    }

    private void disconnect() {
        guests.forEach(Controller::close);
        guests.clear();
    }

    @Override
    public synchronized void close() {
        closed = true;
        door.ifPresent(GuestDoor::close);
        student.ifPresent(RobotProcess::close);
        disconnect();
        trial.leave();
    }
}
