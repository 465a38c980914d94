package org.robonewbie.studio.file;

import java.io.IOException;
import java.io.InputStream;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.file.UnwritableFileException;
import org.robonewbie.simulator.recording.DamagedRecordingException;
import org.robonewbie.studio.service.PageRequest;

/** HTTP endpoint for part of the studio's API. Converts exceptions to error responses. */
public abstract class ApiHandler extends Handler.Abstract {

    private static final String API = "/api/";

    private final Set<PageRequest> requests;

    /**
     * Creates the endpoint.
     *
     * @param requests the requests that it answers, in the order of their declaration
     */
    protected ApiHandler(EnumSet<PageRequest> requests) {
        this.requests = EnumSet.copyOf(requests);
    }

    /**
     * Handles a request.
     *
     * @param asked what is requested
     * @param path decoded segments of its path below {@code /api/}
     * @param request the HTTP request
     * @return the response
     * @throws IOException if a file cannot be read or written
     * @throws IllegalArgumentException if the request is refused; the message gives the reason
     * @throws IllegalStateException if the request is refused in the current state; the message gives the reason
     */
    protected abstract Answer answer(PageRequest asked, List<String> path, Request request) throws IOException;

    /**
     * Explains an unexpected problem to the user.
     *
     * @param problem the problem
     * @return what failed and what to check
     */
    protected abstract String explain(IOException problem);

    /**
     * Explains why a file in a folder cannot be accessed.
     *
     * @param what subject of the sentence, such as {@code The scene}
     * @param folder the folder, such as {@code its folder}
     * @param problem the problem
     * @return what failed and what to check
     */
    protected static String explain(String what, String folder, IOException problem) {
        return what + " cannot be read or written: " + problem.getMessage() + ". Check that " + folder
                + " is writable and that there is free disk space.";
    }

    @Override
    public final boolean handle(Request request, Response response, Callback callback) {
        String address = Request.getPathInContext(request);
        if (!address.startsWith(API)) {
            return false;
        }
        Optional<Answer> answer = answerOrRefuse(address.substring(API.length()), request);
        answer.ifPresent(found -> found.send(response, callback));
        return answer.isPresent();
    }

    private Optional<Answer> answerOrRefuse(String address, Request request) {
        try {
            List<String> path = PathPart.decodeAll(address);
            Optional<PageRequest> asked = requests.stream()
                    .filter(each -> each.fits(request.getMethod(), path))
                    .findFirst();
            return asked.isPresent() ? Optional.of(answer(asked.get(), path, request)) : Optional.empty();
        } catch (RefusedException refused) {
            return Optional.of(Answer.refused(refused.status(), refused.getMessage()));
        } catch (IllegalArgumentException
                | IllegalStateException
                | UnreadableFileException
                | DamagedRecordingException refused) {
            return Optional.of(Answer.refused(409, refused.getMessage()));
        } catch (UnwritableFileException unwritable) {
            return Optional.of(Answer.refused(500, unwritable.getMessage()));
        } catch (IOException problem) {
            return Optional.of(Answer.refused(500, explain(problem)));
        }
    }

    /**
     * Returns a query parameter.
     *
     * @param request the request
     * @param name name of the parameter
     * @return its value; empty if it is missing
     */
    protected static String parameter(Request request, String name) {
        return Optional.ofNullable(Request.extractQueryParameters(request).getValue(name))
                .orElse("");
    }

    /**
     * Returns a header of a request.
     *
     * @param request the request
     * @param name name of the header
     * @return its value; empty if it is missing
     */
    protected static String header(Request request, String name) {
        return Optional.ofNullable(request.getHeaders().get(name)).orElse("");
    }

    /**
     * Reads the body of a request.
     *
     * @param request the request
     * @param maxBytes maximum size
     * @param what subject of the error message for a body that is too large, such as {@code A program}
     * @return the body
     * @throws IOException if the connection fails
     */
    protected static byte[] body(Request request, int maxBytes, String what) throws IOException {
        if (request.getLength() < 0 || request.getLength() > maxBytes) {
            throw new RefusedException(413, what + " may have at most " + maxBytes + " bytes.");
        }
        try (InputStream stream = Content.Source.asInputStream(request)) {
            return stream.readNBytes(maxBytes);
        }
    }
}
