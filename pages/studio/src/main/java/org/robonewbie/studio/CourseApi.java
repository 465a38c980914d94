package org.robonewbie.studio;

import java.io.IOException;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import org.eclipse.jetty.server.Request;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.service.PageRequest;
import org.robonewbie.studio.service.PageService;

/** HTTP endpoint {@code /api/course} for the exercises. */
final class CourseApi extends ApiHandler {

    private final Optional<PageService> course;

    /**
     * Creates the endpoint.
     *
     * @param course handles the requests; empty for a studio without exercises
     */
    CourseApi(Optional<PageService> course) {
        super(EnumSet.range(PageRequest.COURSE, PageRequest.SOLUTION));
        this.course = course;
    }

    @Override
    protected Answer answer(PageRequest asked, List<String> path, Request request) throws IOException {
        return Answer.json(
                course.isPresent()
                        ? course.get()
                                .answer(
                                        request.getMethod(),
                                        path.subList(1, path.size()),
                                        name -> parameter(request, name))
                        : "{\"lessons\":[]}");
    }

    @Override
    protected String explain(IOException problem) {
        return "The request failed: " + problem.getMessage();
    }
}
