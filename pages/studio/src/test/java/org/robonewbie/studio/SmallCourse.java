package org.robonewbie.studio;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.studio.course.Attempt;
import org.robonewbie.studio.course.Attempt.State;
import org.robonewbie.studio.course.CourseService;
import org.robonewbie.studio.course.Help;
import org.robonewbie.studio.course.Lesson;
import org.robonewbie.studio.course.Standings;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.watch.WatchedTrial;

/** A course of two exercises; the test determines the results of trials. */
final class SmallCourse implements CourseService, AutoCloseable {

    private final ShownSimulation shown;
    private final SimulationControl freePitch;
    private final List<String> programs = new CopyOnWriteArrayList<>(List.of("Other.java"));
    private final List<String> hints = List.of("Look first.", "Then kick.");
    private volatile int open;
    private volatile String language = "en";
    private final AtomicLong begun = new AtomicLong();
    private volatile Attempt attempt = Attempt.NONE;
    private WatchedTrial view = new WatchedTrial();
    private Thread trial = new Thread();

    SmallCourse(ShownSimulation shown, SimulationControl freePitch) {
        this.shown = shown;
        this.freePitch = freePitch;
    }

    @Override
    public List<Lesson> lessons() {
        return List.of(
                new Lesson(
                        1,
                        "arms",
                        "Raise arms",
                        "Raise both.",
                        "first steps",
                        15,
                        10,
                        "docs/a.html",
                        "Arms.java",
                        new Lesson.Standing(2, 8.5, true, 7)),
                new Lesson(
                        2,
                        "kick",
                        language.equals("de") ? "Ein Schuss" : "A kick",
                        language.equals("de") ? "Schieß ihn." : "Kick it.",
                        "challenge",
                        120,
                        10,
                        language.equals("de") ? "docs/exercises/de/k.html" : "docs/exercises/k.html",
                        "Kick.java",
                        Lesson.Standing.NONE));
    }

    @Override
    public String language() {
        return language;
    }

    @Override
    public void speak(String code) {
        language = code;
    }

    @Override
    public List<String> programs() {
        return programs;
    }

    @Override
    public String handOut(String exercise) {
        if (programs.contains("Kick.java")) {
            throw new IllegalArgumentException("There is a file Kick.java already, and it is kept.");
        }
        programs.add(0, "Kick.java");
        return "Kick.java";
    }

    @Override
    public void begin(String exercise, String program, int trials) {
        long id = begun.incrementAndGet();
        attempt = new Attempt(id, State.RUNNING, exercise, program, 3110, trials, List.of(), 0, false, "");
        close();
        view = view.next(new TrialLabel(exercise, id, 1));
        trial = new Thread(() -> play(view), "trial");
        trial.setDaemon(true);
        trial.start();
        shown.show(view);
    }

    private static void play(WatchedTrial view) {
        Scene scene = Scene.of(RobotStart.at(-1, 0));
        try (Trial trial = Trial.observed(scene, 1, view, RecordingTarget.NONE, start -> Controller.ofSpeeds())) {
            while (!Thread.currentThread().isInterrupted()) {
                trial.step();
            }
        }
    }

    /** Sets the result of the current trial. */
    void judge(Attempt.Judged trial, String output) {
        attempt = new Attempt(
                attempt.id(),
                State.OVER,
                attempt.exercise(),
                attempt.program(),
                attempt.port(),
                1,
                List.of(trial),
                trial.points(),
                trial.passed(),
                output);
    }

    @Override
    public void leave() {
        close();
        attempt = Attempt.NONE;
        shown.show(freePitch);
    }

    @Override
    public Attempt attempt() {
        return attempt;
    }

    @Override
    public Standings standings() {
        return new Standings("1 of 2 exercises passed, 8.5 of 20 points, 7 min", List.of("First success"), "name\r\n");
    }

    @Override
    public Help help(String exercise) {
        return new Help(hints.subList(0, open), hints.size(), true, 2 - open);
    }

    @Override
    public Help nextHint(String exercise) {
        open = Math.min(open + 1, hints.size());
        return help(exercise);
    }

    @Override
    public String solution(String exercise) {
        return "public class Kick extends Agent {}";
    }

    /** Ends the current trial. */
    @Override
    public void close() {
        trial.interrupt();
    }
}
