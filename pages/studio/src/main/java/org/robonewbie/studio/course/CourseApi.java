package org.robonewbie.studio.course;

import com.google.gson.Gson;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.util.Optional;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.PathPart;

/**
 * HTTP endpoint for exercises.
 *
 * <pre>
 * GET    /api/course                the exercises and the programs in the working directory
 * POST   /api/course/language?code=de   sets the language
 * GET    /api/course/attempt        state of the current attempt
 * POST   /api/course/NAME?program=FILE&amp;trials=N   starts an attempt
 * PUT    /api/course/NAME           writes the starter program
 * DELETE /api/course/attempt        ends the attempt
 * GET    /api/course/NAME/help      the opened hints
 * POST   /api/course/NAME/hint      opens the next hint
 * POST   /api/course/NAME/solution  returns the sample solution
 * </pre>
 */
public final class CourseApi extends Handler.Abstract {

    private static final String COURSE = "/api/course";
    private static final String ATTEMPT = "/api/course/attempt";
    private static final String LANGUAGE = "/api/course/language";
    private static final int MAX_TRIALS = 20;
    private static final Gson GSON = new Gson();

    private final Optional<CourseService> course;

    /**
     * Creates the endpoint.
     *
     * @param course the exercises; empty for a studio without exercises
     */
    public CourseApi(Optional<CourseService> course) {
        this.course = course;
    }

    @Override
    public boolean handle(Request request, Response response, Callback callback) {
        String path = Request.getPathInContext(request);
        if (!path.startsWith(COURSE)) {
            return false;
        }
        try {
            String answer = course.isPresent() ? answer(course.get(), request, path) : "{\"lessons\":[]}";
            Answer.json(answer).send(response, callback);
        } catch (IllegalArgumentException refused) {
            Answer.refused(409, refused.getMessage()).send(response, callback);
        } catch (IOException problem) {
            Answer.refused(500, "The request failed: " + problem.getMessage()).send(response, callback);
        }
        return true;
    }

    private static String answer(CourseService course, Request request, String path) throws IOException {
        if (path.equals(ATTEMPT)) {
            if (request.getMethod().equals("DELETE")) {
                course.leave();
            }
            return GSON.toJson(course.attempt());
        }
        if (path.equals(LANGUAGE) && request.getMethod().equals("POST")) {
            course.speak(parameter(request, "code"));
        }
        if (path.equals(COURSE) || path.equals(LANGUAGE)) {
            return overview(course);
        }
        return ofExercise(course, request, path);
    }

    private static String overview(CourseService course) {
        JsonObject json = new JsonObject();
        json.addProperty("language", course.language());
        json.add("lessons", GSON.toJsonTree(course.lessons()));
        json.add("programs", GSON.toJsonTree(course.programs()));
        json.add("standings", GSON.toJsonTree(course.standings()));
        return GSON.toJson(json);
    }

    private static String ofExercise(CourseService course, Request request, String path) throws IOException {
        String[] words = path.substring(COURSE.length() + 1).split("/", 2);
        String name = PathPart.decode(words[0]);
        if (words.length > 1) {
            return GSON.toJson(help(course, name, words[1], request.getMethod().equals("POST")));
        }
        if (request.getMethod().equals("PUT")) {
            return GSON.toJson(course.handOut(name));
        }
        if (request.getMethod().equals("POST")) {
            course.begin(name, parameter(request, "program"), trials(parameter(request, "trials")));
        }
        return GSON.toJson(course.attempt());
    }

    private static Object help(CourseService course, String exercise, String wish, boolean opens) {
        if (wish.equals("hint") && opens) {
            return course.nextHint(exercise);
        }
        return wish.equals("solution") && opens ? course.solution(exercise) : course.help(exercise);
    }

    private static String parameter(Request request, String name) {
        return Optional.ofNullable(Request.extractQueryParameters(request).getValue(name))
                .orElse("");
    }

    private static int trials(String text) {
        try {
            return Math.max(1, Math.min(MAX_TRIALS, Integer.parseInt(text)));
        } catch (NumberFormatException noNumber) {
            throw new IllegalArgumentException(
                    "The number of trials must be an integer from 1 to " + MAX_TRIALS + ".", noNumber);
        }
    }
}
