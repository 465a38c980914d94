package org.robonewbie.studio.program;

import com.google.gson.Gson;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.jetty.server.Request;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.file.PathPart;
import org.robonewbie.studio.file.RefusedException;

/**
 * HTTP endpoint for the program editor. PATH is the path of a Java file, relative to the studio's folder.
 *
 * <pre>
 * GET              /api/programs                    the files, drafts of unsaved changes, and the examples
 * GET PUT          /api/programs/own/PATH           header Known-Version on PUT: the version the page has read, empty for a new file
 * GET              /api/programs/example/NAME
 * GET              /api/programs/new/PATH?example=NAME    the source of a new program
 * GET PUT DELETE   /api/programs/draft/PATH
 * GET PUT          /api/programs/history/PATH       saved versions, a JSON array; pruned by the pages
 * POST             /api/programs/check/PATH         body: the editor's text; returns the compiler's diagnostics
 * POST             /api/programs/complete/PATH?at=N body: the editor's text; returns completion proposals
 * POST             /api/programs/run/PATH?world=keep    compiles the saved file and replaces the running program
 * GET DELETE       /api/programs/run                state of the running program; DELETE stops it
 * </pre>
 */
public final class ProgramApi extends ApiHandler {

    private static final String PROGRAMS = "/api/programs";
    private static final Pattern PLACE = Pattern.compile("/(\\w+)(?:/(.*))?");
    private static final Gson GSON = new Gson();
    private static final int MAX_HISTORY_BYTES = 4 << 20;
    private static final byte[] NO_HISTORY = {'[', ']'};

    private final ProgramFolder folder;
    private final ProgramFolder drafts;
    private final ProgramFolder histories;
    private final Optional<CompilerService> compiler;
    private final Optional<ProgramService> service;

    /**
     * Creates the endpoint.
     *
     * @param compiler compiles and starts programs; empty for a studio without programs
     * @param arena the pitch on which they run
     */
    public ProgramApi(Optional<CompilerService> compiler, Arena arena) {
        Path folder = compiler.map(CompilerService::folder).orElse(Path.of(""));
        this.folder = new ProgramFolder(folder);
        Path studio = folder.resolve(".studio");
        this.drafts = new ProgramFolder(studio.resolve("programs"));
        this.histories = new ProgramFolder(studio.resolve("history"), MAX_HISTORY_BYTES, ".json");
        this.compiler = compiler;
        this.service = compiler.map(given -> new ProgramService(given, arena));
    }

    /** Stops the running program. */
    public void close() {
        service.ifPresent(ProgramService::close);
    }

    @Override
    protected Optional<Answer> answer(Request request, String path) throws IOException {
        return path.equals(PROGRAMS) || path.startsWith(PROGRAMS + "/")
                ? Optional.of(reply(request, path.substring(PROGRAMS.length())))
                : Optional.empty();
    }

    @Override
    protected String explain(IOException problem) {
        return explain("The file", folder.folder(), problem);
    }

    private Answer reply(Request request, String place) throws IOException {
        if (place.isEmpty()) {
            return Answer.json(GSON.toJson(list()));
        }
        Matcher matcher = PLACE.matcher(place);
        if (compiler.isEmpty() || !matcher.matches()) {
            throw unknown(request, place);
        }
        String name = matcher.group(2) == null ? "" : PathPart.decode(matcher.group(2));
        String order = request.getMethod() + " " + matcher.group(1);
        return switch (matcher.group(1)) {
            case "own", "draft", "history" -> fileAnswer(request, order, name);
            case "run" -> runAnswer(request, order, name);
            default -> workshopAnswer(compiler.get(), request, order, name);
        };
    }

    private static RefusedException unknown(Request request, String place) {
        return new RefusedException(
                404, "Unknown request: " + request.getMethod() + " " + place + ". Reload the page.");
    }

    private Answer fileAnswer(Request request, String order, String path) throws IOException {
        return switch (order) {
            case "GET own" -> Answer.file(found(folder.read(path), path));
            case "GET draft" -> Answer.file(found(drafts.read(path), path));
            case "GET history" -> Answer.file(histories.read(path).orElse(NO_HISTORY));
            case "PUT own" -> {
                String version = folder.write(path, body(request), knownVersion(request));
                drafts.remove(path, version); // another window may hold a different draft
                yield Answer.written(version);
            }
            case "PUT draft" -> Answer.written(drafts.writeIfKnown(path, body(request), knownVersion(request)));
            case "PUT history" -> {
                histories.overwrite(path, body(request, MAX_HISTORY_BYTES, "A history"));
                yield Answer.done();
            }
            case "DELETE draft" -> {
                drafts.remove(path, knownVersion(request));
                yield Answer.done();
            }
            default -> throw unknown(request, path);
        };
    }

    private Answer runAnswer(Request request, String order, String path) throws IOException {
        ProgramService runs = service.orElseThrow();
        return switch (order) {
            case "GET run" -> Answer.json(GSON.toJson(runs.state()));
            case "DELETE run" -> Answer.json(GSON.toJson(runs.stop()));
            case "POST run" -> {
                found(folder.read(path), path);
                boolean fromTheStart = !"keep".equals(parameter(request, "world"));
                yield Answer.json(GSON.toJson(runs.run(path, folder.file(path), fromTheStart)));
            }
            default -> throw unknown(request, path);
        };
    }

    private Answer workshopAnswer(CompilerService open, Request request, String order, String name) throws IOException {
        return switch (order) {
            case "GET example" -> Answer.text(found(open.example(name), name));
            case "GET new" -> {
                Optional<String> example = Optional.of(parameter(request, "example"))
                        .filter(given -> !given.isEmpty())
                        .map(given -> found(open.example(given), given));
                yield Answer.text(open.newProgram(folder.file(name), example));
            }
            case "POST check" -> Answer.json(GSON.toJson(open.check(folder.file(name), text(request))));
            case "POST complete" -> {
                String text = text(request);
                yield Answer.json(GSON.toJson(open.complete(folder.file(name), text, at(request, text))));
            }
            default -> throw unknown(request, name);
        };
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

    private static String text(Request request) throws IOException {
        return new String(body(request), StandardCharsets.UTF_8);
    }

    private static byte[] body(Request request) throws IOException {
        return body(request, ProgramFolder.MAX_BYTES, "A program");
    }

    private JsonObject list() throws IOException {
        JsonObject json = new JsonObject();
        json.addProperty("folder", folder.folder().toString());
        boolean isOpen = compiler.isPresent();
        json.addProperty("open", isOpen);
        json.add("own", GSON.toJsonTree(isOpen ? folder.list() : List.of()));
        json.add("drafts", GSON.toJsonTree(isOpen ? drafts.listAll() : List.of()));
        json.add(
                "examples",
                GSON.toJsonTree(compiler.map(CompilerService::examples).orElse(List.of())));
        compiler.flatMap(CompilerService::first)
                .filter(first -> first.program().isRunning())
                .ifPresent(first ->
                        json.add("first", GSON.toJsonTree(Map.of("path", first.path(), "example", first.example()))));
        return json;
    }
}
