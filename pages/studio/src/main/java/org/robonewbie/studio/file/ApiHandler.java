package org.robonewbie.studio.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Optional;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.file.UnwritableFileException;
import org.robonewbie.simulator.recording.DamagedRecordingException;

/** HTTP endpoint for part of the studio's API. Converts exceptions to error responses. */
public abstract class ApiHandler extends Handler.Abstract {

    /** Creates the endpoint. */
    protected ApiHandler() {}

    /**
     * Handles a request.
     *
     * @param request the request
     * @param path its path
     * @return the response; empty if the path belongs to another endpoint
     * @throws IOException if a file cannot be read or written
     * @throws IllegalArgumentException if the request is refused; the message gives the reason
     * @throws IllegalStateException if the request is refused in the current state; the message gives the reason
     */
    protected abstract Optional<Answer> answer(Request request, String path) throws IOException;

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
     * @param folder the folder
     * @param problem the problem
     * @return what failed and what to check
     */
    protected static String explain(String what, Path folder, IOException problem) {
        return what + " cannot be read or written: " + problem.getMessage() + ". Check that the folder " + folder
                + " is writable and that there is free disk space.";
    }

    @Override
    public final boolean handle(Request request, Response response, Callback callback) {
        Optional<Answer> answer = answerOrRefuse(request);
        answer.ifPresent(found -> found.send(response, callback));
        return answer.isPresent();
    }

    private Optional<Answer> answerOrRefuse(Request request) {
        try {
            return answer(request, Request.getPathInContext(request));
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
     * Returns the version of the file that the page has read.
     *
     * @param request the request
     * @return the version; empty for a new file
     */
    protected static String knownVersion(Request request) {
        return header(request, "Known-Version");
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
