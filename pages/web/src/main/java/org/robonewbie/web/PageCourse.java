package org.robonewbie.web;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.progress.ExerciseProgress;
import org.robonewbie.exercises.progress.Progress;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.ProgressStore;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.exercises.service.CourseHost;
import org.robonewbie.exercises.service.CourseService;
import org.robonewbie.simulator.json.Json;

/**
 * Exercises in the page. Each request contains the browser's stored data: language, progress, names of programs, and the requested
 * solution. The page receives changes as messages and stores them.
 */
final class PageCourse implements CourseHost, ProgressStore {

    private final CourseService service;
    private Starter starter = (exercise, id, trials, judged) -> {
        throw new IllegalArgumentException("The page starts any attempts that use the other program.");
    };
    private ServiceRequest request = new ServiceRequest(new JsonObject());
    private Progress progress = new Progress(Map.of());

    /** Starts attempts at exercises. */
    @FunctionalInterface
    interface Starter {

        /** Starts an attempt with the program whose classes were added, and shows its trials. */
        Attempt begin(Exercise exercise, long id, int trials, Consumer<Grade> judged);
    }

    PageCourse() {
        service = new CourseService(new ProgressService(this, new SolutionRepository(this::solution)), this, "");
    }

    void startWith(Starter programs) {
        starter = programs;
    }

    @Override
    public boolean acceptsAgents() {
        return false;
    }

    /** Handles a request; returns JSON, or a sentence if the request is rejected. */
    String answer(ServiceRequest asked) {
        request = asked;
        JsonObject json = request.json();
        progress = Progress.parse(json.get("progress").toString()).orElse(progress);
        return request.answer((method, path, parameters) -> {
            service.setLanguage(json.get("language").getAsString());
            return service.answer(method, path, parameters);
        });
    }

    /** Ends the current attempt. Called when another program takes over the world. */
    void close() {
        service.close();
    }

    private Optional<String> solution(String file) {
        return Optional.ofNullable(request.json().getAsJsonObject("solutions").get(file))
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
        PageContext.post(
                "progress", new Progress(Map.of(exercise.name(), state)).json().toString());
        return state;
    }

    @Override
    public List<String> programs() {
        return request.texts("programs");
    }

    @Override
    public boolean create(String file, String text) {
        if (programs().contains(file) || request.texts("drafts").contains(file)) {
            return false;
        }
        PageContext.post("starter", Json.object("path", file, "text", text).toString());
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
        PageContext.post("freePitch", "");
    }
}
