package org.robonewbie.exercises.service;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.FirstMinute;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Grade.SeededScore;
import org.robonewbie.exercises.Language;
import org.robonewbie.exercises.Score;
import org.robonewbie.exercises.progress.ExerciseProgress;
import org.robonewbie.exercises.progress.Progress;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.ProgressTable;
import org.robonewbie.exercises.progress.SolutionRepository;
import org.robonewbie.exercises.progress.Worksheet;

/**
 * Serves exercises to the pages of the studio and the web edition. Responses are JSON. Thread-safe.
 *
 * <pre>
 * GET                               the exercises, the first minute, the student's programs and progress
 * POST   language?code=de           sets the language
 * GET    attempt                    status of the current attempt
 * DELETE attempt                    ends the attempt
 * POST   NAME?program=FILE&amp;trials=N starts an attempt
 * PUT    NAME                       writes the starter program
 * GET    NAME/help                  the hints opened so far
 * POST   NAME/hint                  opens the next hint
 * POST   NAME/solution              returns the sample solution
 * </pre>
 */
public final class CourseService implements AutoCloseable {

    private static final int MAX_TRIALS = 20;

    private final ProgressService progress;
    private final CourseHost host;
    private final String student;
    private Language language = Language.ENGLISH;
    private Optional<Started> current = Optional.empty();
    private long attempts;

    /**
     * Creates the service.
     *
     * @param progress stores the student's progress
     * @param host provides the student's programs, and the pitch for attempts
     * @param student name of the student for the teacher's table
     */
    public CourseService(ProgressService progress, CourseHost host, String student) {
        this.progress = progress;
        this.host = host;
        this.student = student;
    }

    private record Started(long id, Exercise exercise, String program, int trials, CourseHost.Attempt attempt) {}

    /**
     * Sets the language of titles, goals, worksheets, findings and hints; the default is English.
     *
     * @param code two-letter code
     * @throws IllegalArgumentException if the language is not available
     */
    public synchronized void setLanguage(String code) {
        language =
                Language.of(code).orElseThrow(() -> new IllegalArgumentException("Unknown language \"" + code + "\"."));
    }

    /**
     * Handles a request.
     *
     * @param method HTTP method
     * @param path decoded segments of the path below {@code course}
     * @param parameters returns the value of the query parameter with a given name; empty if it is missing
     * @return JSON
     * @throws IOException if a file cannot be written, or no port is available
     * @throws IllegalArgumentException if the request is rejected; the message gives the reason
     */
    public synchronized String answer(String method, List<String> path, UnaryOperator<String> parameters)
            throws IOException {
        boolean isPost = method.equals("POST");
        switch (path.isEmpty() ? "" : path.get(0)) {
            case "" -> {}
            case "language" -> {
                if (isPost) {
                    setLanguage(parameters.apply("code"));
                }
            }
            case "attempt" -> {
                if (method.equals("DELETE") && current.isPresent()) {
                    close();
                    host.showFreePitch();
                }
                return attempt().toString();
            }
            default -> {
                Exercise exercise = find(path.get(0));
                if (path.size() > 1) {
                    return help(exercise, isPost ? path.get(1) : "").toString();
                }
                if (method.equals("PUT")) {
                    return new JsonPrimitive(writeStarter(exercise)).toString();
                }
                if (isPost) {
                    begin(exercise, parameters.apply("program"), trials(parameters.apply("trials")));
                }
                return attempt().toString();
            }
        }
        return overview().toString();
    }

    private static Exercise find(String name) {
        return Exercises.find(name)
                .or(() -> FirstMinute.find(name))
                .orElseThrow(() ->
                        new IllegalArgumentException("There is no exercise named \"" + name + "\". Reload the page."));
    }

    private static int trials(String text) {
        try {
            return Math.max(1, Math.min(MAX_TRIALS, Integer.parseInt(text)));
        } catch (NumberFormatException noNumber) {
            throw new IllegalArgumentException(
                    "The number of trials must be an integer from 1 to " + MAX_TRIALS + ".", noNumber);
        }
    }

    private JsonObject overview() {
        Progress reached = progress.progress();
        JsonArray lessons = new JsonArray();
        Exercises.all().forEach(exercise -> lessons.add(lesson(exercise, reached.of(exercise))));
        ProgressTable table = new ProgressTable(reached);
        JsonObject standings = new JsonObject();
        standings.addProperty("sum", table.sum());
        standings.add("badges", array(table.badges()));
        standings.addProperty("csv", table.csv(student));
        JsonObject json = new JsonObject();
        json.addProperty("language", language.code());
        json.add("lessons", lessons);
        json.add("programs", array(host.programs()));
        json.addProperty("acceptsAgents", host.acceptsAgents());
        json.add("standings", standings);
        json.add("firstMinute", new FirstMinuteWriter(language, reached).json());
        return json;
    }

    private JsonObject lesson(Exercise exercise, ExerciseProgress state) {
        JsonObject standing = new JsonObject();
        standing.addProperty("tries", state.tries());
        standing.addProperty("best", state.bestPoints());
        standing.addProperty("passed", state.passed());
        standing.addProperty("minutes", TimeUnit.SECONDS.toMinutes(state.seconds()));
        JsonObject json = new JsonObject();
        json.addProperty("number", exercise.number());
        json.addProperty("name", exercise.name());
        json.addProperty("title", Worksheet.of(exercise, language).title());
        json.addProperty("goal", language.translated(exercise.goal()));
        json.addProperty("level", language.translated(exercise.level()));
        json.addProperty("minutes", exercise.minutes());
        json.addProperty("points", Score.MAX_POINTS);
        json.addProperty("worksheet", "docs/exercises/" + language.worksheet(exercise) + ".html");
        json.addProperty("file", exercise.fileName());
        json.add("standing", standing);
        return json;
    }

    private static JsonArray array(List<String> texts) {
        JsonArray json = new JsonArray();
        texts.forEach(json::add);
        return json;
    }

    private JsonElement help(Exercise exercise, String wish) {
        if (wish.equals("solution")) {
            SolutionRepository.Answer answer = progress.solution(exercise);
            if (!answer.open()) {
                throw new IllegalArgumentException(answer.text());
            }
            return new JsonPrimitive(answer.text());
        }
        ProgressService.Hints hints =
                wish.equals("hint") ? progress.nextHint(exercise, language) : progress.hints(exercise, language);
        JsonObject json = new JsonObject();
        json.add("hints", array(hints.open()));
        json.addProperty("allHints", hints.all());
        json.addProperty("solution", hints.solution());
        json.addProperty("triesLeft", hints.triesLeft());
        return json;
    }

    private String writeStarter(Exercise exercise) throws IOException {
        String file = exercise.fileName();
        if (!host.create(file, exercise.startCode())) {
            throw new IllegalArgumentException(
                    "The file " + file + " already exists and is kept. Rename it to start over.");
        }
        progress.begun(exercise);
        return file;
    }

    private void begin(Exercise exercise, String program, int trials) throws IOException {
        attempts++;
        Language spoken = language;
        CourseHost.Attempt attempt = host.begin(
                exercise,
                attempts,
                program,
                trials,
                grade -> progress.graded(exercise, grade.points(), grade.passed(), spoken));
        current = Optional.of(new Started(attempts, exercise, program, trials, attempt));
    }

    private JsonObject attempt() {
        return current.map(this::json).orElseGet(() -> {
            JsonObject none = new JsonObject();
            none.addProperty("state", "NONE");
            none.add("judged", new JsonArray());
            none.addProperty("output", "");
            return none;
        });
    }

    private JsonObject json(Started started) {
        CourseHost.Status status = started.attempt().status();
        Grade grade = status.grade();
        JsonArray judged = new JsonArray();
        grade.trials().forEach(trial -> judged.add(json(trial)));
        JsonObject json = new JsonObject();
        json.addProperty("id", started.id());
        json.addProperty("state", status.state().name());
        json.addProperty("exercise", started.exercise().name());
        json.addProperty("program", started.program());
        json.addProperty("port", status.port());
        json.addProperty("trials", started.trials());
        json.add("judged", judged);
        json.addProperty("points", grade.points());
        json.addProperty("passed", grade.passed() && judged.size() == started.trials());
        json.addProperty("output", status.output());
        return json;
    }

    private JsonObject json(SeededScore trial) {
        Score score = trial.score().in(language);
        JsonObject json = new JsonObject();
        json.addProperty("seed", trial.seed());
        json.addProperty("passed", score.passed());
        json.addProperty("points", score.points());
        json.addProperty("finding", score.finding());
        json.addProperty("hint", score.hint());
        return json;
    }

    /** Ends the current attempt, if there is one. */
    @Override
    public synchronized void close() {
        current.ifPresent(started -> started.attempt().close());
        current = Optional.empty();
    }
}
