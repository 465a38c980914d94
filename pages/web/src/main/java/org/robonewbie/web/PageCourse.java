package org.robonewbie.web;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.StreamSupport;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.progress.ExerciseProgress;
import org.robonewbie.exercises.progress.Progress;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.ProgressStore;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.exercises.service.CourseHost;
import org.robonewbie.exercises.service.CourseService;
import org.teavm.jso.JSBody;

/**
 * Exercises in the page. Each request contains what the browser has stored: language, progress, names of programs, and the requested
 * solution. The page receives changes as messages and stores them.
 */
final class PageCourse implements CourseHost, ProgressStore {

    private final Starter starter;
    private final CourseService service;
    private JsonObject request = new JsonObject();
    private Progress progress = new Progress(Map.of());

    /** Starts attempts. */
    @FunctionalInterface
    interface Starter {

        /** Starts an attempt with the program whose classes were added, and shows its trials. */
        Attempt begin(Exercise exercise, long id, int trials, Consumer<Grade> judged);
    }

    PageCourse(Starter starter) {
        this.starter = starter;
        service = new CourseService(new ProgressService(this, new SolutionRepository(this::solution)), this, "");
    }

    @Override
    public boolean acceptsAgents() {
        return false;
    }

    /** Answers a request; returns JSON, or a sentence if the request is refused. */
    String answer(String text) {
        request = JsonParser.parseString(text).getAsJsonObject();
        progress = Progress.parse(request.get("progress").toString()).orElse(progress);
        JsonObject parameters = request.getAsJsonObject("parameters");
        try {
            service.setLanguage(request.get("language").getAsString());
            return service.answer(
                    request.get("method").getAsString(),
                    texts("path"),
                    name -> parameters.has(name) ? parameters.get(name).getAsString() : "");
        } catch (IllegalArgumentException | IOException refused) {
            return String.valueOf(refused.getMessage());
        }
    }

    /** Ends the current attempt, because another program has taken over the world. */
    void close() {
        service.close();
    }

    private List<String> texts(String name) {
        return StreamSupport.stream(request.getAsJsonArray(name).spliterator(), false)
                .map(JsonElement::getAsString)
                .toList();
    }

    private Optional<String> solution(String file) {
        return Optional.ofNullable(request.getAsJsonObject("solutions").get(file))
                .map(JsonElement::getAsString);
    }

    @Override
    public Progress read() {
        return progress;
    }

    @Override
    public ExerciseProgress update(Exercise exercise, UnaryOperator<ExerciseProgress> change) {
        ExerciseProgress state = change.apply(progress.of(exercise));
        progress = progress.with(exercise, state);
        post("progress", new Progress(Map.of(exercise.name(), state)).json().toString());
        return state;
    }

    @Override
    public List<String> programs() {
        return texts("programs");
    }

    @Override
    public boolean create(String file, String text) {
        if (programs().contains(file) || texts("drafts").contains(file)) {
            return false;
        }
        JsonObject created = new JsonObject();
        created.addProperty("path", file);
        created.addProperty("text", text);
        post("starter", created.toString());
        return true;
    }

    @Override
    public Attempt begin(Exercise exercise, long id, String program, int trials, Consumer<Grade> judged) {
        if (program.isEmpty()) {
            throw new IllegalArgumentException("This page runs only programs that were written in it. Choose one.");
        }
        return starter.begin(exercise, id, trials, judged);
    }

    @Override
    public void showFreePitch() {
        post("freePitch", "");
    }

    @JSBody(
            params = {"name", "text"},
            script = "var message = {}; message[name] = text; self.postMessage(message);")
    private static native void post(String name, String text);
}
