package org.robonewbie.studio;

import java.io.IOException;
import java.util.Optional;
import org.eclipse.jetty.server.Request;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.file.PathPart;
import org.robonewbie.studio.service.PageService;

/** HTTP endpoint {@code /api/course} for the exercises. */
final class CourseApi extends ApiHandler {

    private static final String COURSE = "/api/course";

    private final Optional<PageService> course;

    /**
     * Creates the endpoint.
     *
     * @param course handles the requests; empty for a studio without exercises
     */
    CourseApi(Optional<PageService> course) {
        this.course = course;
    }

    @Override
    protected Optional<Answer> answer(Request request, String path) throws IOException {
        if (!path.startsWith(COURSE)) {
            return Optional.empty();
        }
        return Optional.of(Answer.json(
                course.isPresent()
                        ? course.get()
                                .answer(
                                        request.getMethod(),
                                        PathPart.decodeAll(path.substring(COURSE.length())),
                                        name -> parameter(request, name))
                        : "{\"lessons\":[]}"));
    }

    @Override
    protected String explain(IOException problem) {
        return "The request failed: " + problem.getMessage();
    }
}
