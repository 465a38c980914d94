package org.robonewbie.studio.file;

import com.google.gson.Gson;
import java.io.IOException;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.jetty.server.Request;
import org.robonewbie.studio.service.PageRequest;

/**
 * HTTP endpoint for files that pages read and write. A list of files is the JSON object
 * {@code {folder, files: [{path, version}], leftOut: [message]}}.
 */
public final class FileApi extends ApiHandler {

    private static final Gson GSON = new Gson();

    private final Map<String, PageFiles> kinds;

    /**
     * Creates the endpoint.
     *
     * @param kinds files by the name of their kind
     */
    public FileApi(Map<String, PageFiles> kinds) {
        super(EnumSet.range(PageRequest.LIST_FILES, PageRequest.DELETE_FILE));
        this.kinds = Map.copyOf(kinds);
    }

    @Override
    protected Answer answer(PageRequest asked, List<String> segments, Request request) throws IOException {
        PageFiles files = Optional.ofNullable(kinds.get(segments.get(1)))
                .orElseThrow(() -> new RefusedException(404, "There are no files of this kind. Reload the page."));
        String path = String.join("/", segments.subList(2, segments.size()));
        Optional<String> known = Optional.ofNullable(request.getHeaders().get("Known-Version"));
        return switch (asked) {
            case LIST_FILES -> Answer.json(GSON.toJson(files.list()));
            case WRITE_FILE -> Answer.written(files.write(path, body(request, files), known));
            case DELETE_FILE -> {
                files.remove(path, known);
                yield Answer.done();
            }
            default -> Answer.file(files.read(path).orElseThrow(() -> missing(files, path)));
        };
    }

    @Override
    protected String explain(IOException problem) {
        return explain("The file", "its folder", problem);
    }

    private static RefusedException missing(PageFiles files, String path) {
        return new RefusedException(404, "There is no " + files.kind() + " named \"" + path + "\".");
    }

    private static byte[] body(Request request, PageFiles files) throws IOException {
        return files.maxBytes() == 0 ? new byte[0] : body(request, files.maxBytes(), "A " + files.kind());
    }
}
