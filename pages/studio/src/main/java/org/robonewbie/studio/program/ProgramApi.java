package org.robonewbie.studio.program;

import com.google.gson.Gson;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.jetty.server.Request;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.file.PageFiles;
import org.robonewbie.studio.file.RefusedException;
import org.robonewbie.studio.file.ShippedFiles;
import org.robonewbie.studio.service.PageRequest;

/** HTTP endpoint for the program editor: compiler, completion and the running program. The files are those of {@link #files}. */
public final class ProgramApi extends ApiHandler {

    private static final Gson GSON = new Gson();

    private final ProgramFolder folder;
    private final Optional<CompilerService> compiler;
    private final Optional<ProgramService> service;

    /**
     * Creates the endpoint.
     *
     * @param compiler compiles and starts programs; empty for a studio without programs
     * @param arena the pitch on which they run
     */
    public ProgramApi(Optional<CompilerService> compiler, Arena arena) {
        super(EnumSet.range(PageRequest.PROGRAMS, PageRequest.STOP_PROGRAM));
        this.folder = ProgramFolder.of(compiler.map(CompilerService::folder).orElse(Path.of("")));
        this.compiler = compiler;
        this.service = compiler.map(given -> new ProgramService(given, arena));
    }

    /** {@return the files of the program editor by the name of their kind; none of each in a studio without programs} */
    public Map<String, PageFiles> files() {
        PageFiles none = new ShippedFiles("program", List.of(), name -> Optional.empty());
        boolean isOpen = compiler.isPresent();
        return Map.of(
                "program", isOpen ? folder : none,
                "program-draft", isOpen ? folder.drafts().orElseThrow() : none,
                "program-history", isOpen ? ProgramFolder.histories(folder.folder()) : none,
                "example", compiler.map(ProgramApi::examples).orElse(none));
    }

    private static PageFiles examples(CompilerService open) {
        return new ShippedFiles(
                "program",
                open.examples(),
                name -> open.example(name).map(text -> text.getBytes(StandardCharsets.UTF_8)));
    }

    /** Stops the running program. */
    public void close() {
        service.ifPresent(ProgramService::close);
    }

    @Override
    protected Answer answer(PageRequest asked, List<String> segments, Request request) throws IOException {
        if (asked == PageRequest.PROGRAMS) {
            return Answer.json(GSON.toJson(state()));
        }
        CompilerService open =
                compiler.orElseThrow(() -> new RefusedException(404, "Programs cannot be written here."));
        ProgramService runs = service.orElseThrow();
        String path = String.join("/", segments.subList(2, segments.size()));
        return switch (asked) {
            case NEW_PROGRAM -> {
                Optional<String> example = Optional.of(parameter(request, "example"))
                        .filter(given -> !given.isEmpty())
                        .map(given -> found(open.example(given), given));
                yield Answer.text(open.newProgram(folder.file(path), example));
            }
            case CHECK_PROGRAM -> Answer.json(GSON.toJson(open.check(folder.file(path), text(request))));
            case COMPLETE_PROGRAM -> {
                String text = text(request);
                yield Answer.json(GSON.toJson(open.complete(folder.file(path), text, at(request, text))));
            }
            case RUN_PROGRAM -> {
                found(folder.read(path), path);
                boolean fromTheStart = !"keep".equals(parameter(request, "world"));
                yield Answer.json(GSON.toJson(runs.run(path, folder.file(path), fromTheStart)));
            }
            case STOP_PROGRAM -> Answer.json(GSON.toJson(runs.stop()));
            default -> Answer.json(GSON.toJson(runs.state()));
        };
    }

    @Override
    protected String explain(IOException problem) {
        return explain("The file", "the folder " + folder.folder(), problem);
    }

    private static <T> T found(Optional<T> content, String name) {
        return content.orElseThrow(() -> new RefusedException(404, "There is no program named \"" + name + "\"."));
    }

    private static int at(Request request, String text) {
        try {
            return Math.max(0, Math.min(text.length(), Integer.parseInt(parameter(request, "at"))));
        } catch (NumberFormatException none) {
            return text.length();
        }
    }

    private String text(Request request) throws IOException {
        return new String(body(request), StandardCharsets.UTF_8);
    }

    private byte[] body(Request request) throws IOException {
        return body(request, folder.maxBytes(), "A program");
    }

    private JsonObject state() {
        JsonObject json = new JsonObject();
        json.addProperty("open", compiler.isPresent());
        compiler.flatMap(CompilerService::first)
                .filter(first -> first.program().isRunning())
                .ifPresent(first ->
                        json.add("first", GSON.toJsonTree(Map.of("path", first.path(), "example", first.example()))));
        return json;
    }
}
