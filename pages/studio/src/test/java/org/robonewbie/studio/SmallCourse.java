package org.robonewbie.studio;

import com.google.gson.Gson;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.UnaryOperator;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.studio.service.PageService;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.watch.WatchedTrial;

/** A course of two exercises; the test determines the results of trials. */
final class SmallCourse implements PageService, AutoCloseable {

    private static final String NONE = "{\"state\":\"NONE\",\"judged\":[],\"output\":\"\"}";

    private final ShownSimulation shown;
    private final SimulationControl freePitch;
    private final List<String> programs = new CopyOnWriteArrayList<>(List.of("Other.java"));
    private final List<String> hints = List.of("Look first.", "Then kick.");
    private int open;
    private String language = "en";
    private int attempts;
    private volatile String attempt = NONE;
    private WatchedTrial view = new WatchedTrial();
    private Thread trial = new Thread();

    SmallCourse(ShownSimulation shown, SimulationControl freePitch) {
        this.shown = shown;
        this.freePitch = freePitch;
    }

    @Override
    public synchronized String answer(String method, List<String> path, UnaryOperator<String> parameters) {
        String request = method + " " + String.join("/", path);
        switch (request) {
            case "POST language" -> language = parameters.apply("code");
            case "DELETE attempt" -> {
                close();
                attempt = NONE;
                shown.show(freePitch);
            }
            case "PUT kick" -> {
                programs.add(0, "Kick.java");
                return "\"Kick.java\"";
            }
            case "POST kick" -> begin(parameters.apply("program"));
            case "POST kick/hint" -> open = Math.min(open + 1, hints.size());
            case "POST kick/solution" -> {
                return "\"public class Kick extends Agent {}\"";
            }
            default -> {}
        }
        return path.isEmpty() || path.contains("language") ? overview() : path.size() > 1 ? help() : attempt;
    }

    private String help() {
        return new Gson()
                .toJson(Map.of(
                        "hints",
                        hints.subList(0, open),
                        "allHints",
                        hints.size(),
                        "solution",
                        true,
                        "triesLeft",
                        hints.size() - open));
    }

    private String overview() {
        boolean german = language.equals("de");
        return """
                {"language":"%s","programs":%s,"acceptsAgents":true,
                "standings":{"sum":"1 of 2 exercises passed, 8.5 of 20 points, 7 min","badges":["First success"],"csv":"name"},
                "lessons":[
                {"number":1,"name":"arms","title":"Raise arms","goal":"Raise both.","level":"first steps","minutes":15,"points":10,
                "worksheet":"docs/a.html","file":"Arms.java","standing":{"tries":2,"best":8.5,"passed":true,"minutes":7}},
                {"number":2,"name":"kick","title":"%s","goal":"%s","level":"challenge","minutes":120,"points":10,
                "worksheet":"docs/exercises/%sk.html","file":"Kick.java",
                "standing":{"tries":0,"best":0,"passed":false,"minutes":0}}]}
                """.formatted(
                        language,
                        new Gson().toJson(programs),
                        german ? "Ein Schuss" : "A kick",
                        german ? "Schieß ihn." : "Kick it.",
                        german ? "de/" : "");
    }

    private void begin(String program) {
        attempts++;
        attempt = attempt("RUNNING", program, "", 0, "");
        close();
        view = view.next(new TrialLabel("kick", attempts, 1));
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

    private String attempt(String state, String program, String judged, int points, String output) {
        return """
                {"id":%d,"state":"%s","exercise":"kick","program":"%s","port":3110,"trials":1,"judged":[%s],"points":%d,
                "passed":false,"output":"%s"}
                """.formatted(attempts, state, program, judged, points, output);
    }

    /** Sets the result of the current trial, which is not passed. */
    synchronized void judge(int points, String finding, String hint, String output) {
        String trial = "{\"seed\":1,\"passed\":false,\"points\":%d,\"finding\":\"%s\",\"hint\":\"%s\"}"
                .formatted(points, finding, hint);
        attempt = attempt("OVER", "Other.java", trial, points, output);
    }

    /** Ends the current trial. */
    @Override
    public void close() {
        trial.interrupt();
    }
}
