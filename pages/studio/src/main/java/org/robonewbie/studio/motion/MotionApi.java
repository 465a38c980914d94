package org.robonewbie.studio.motion;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.jetty.server.Request;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.file.PageFolder;
import org.robonewbie.studio.file.PathPart;
import org.robonewbie.studio.file.RefusedException;

/**
 * HTTP endpoint for the motion editor below {@code /api/}: the robot, motion files, drafts of unsaved changes, the user's postures, and
 * trials with physics.
 *
 * <pre>
 * GET              /api/robot, /api/robot/NAME
 * GET              /api/motions, /api/library/NAME
 * GET PUT          /api/motions/NAME      header Known-Version on PUT: the version that the page has read, empty for a new file
 * GET PUT DELETE   /api/drafts/NAME
 * GET PUT          /api/poses
 * POST             /api/trial             header Start: standing, back or front
 * </pre>
 */
public final class MotionApi extends ApiHandler {

    /** Prefix of all paths of this endpoint. */
    public static final String PATH = "/api/";

    private static final Pattern FILE = Pattern.compile("/api/(robot|motions|library|drafts)/([^/]+)");
    private static final String POSES = "poses";

    private final MotionFolder motions;
    private final MotionFolder drafts;
    private final MotionFolder own;
    private final String robot;

    /**
     * Creates the endpoint.
     *
     * @param folder folder of the motion files; it need not exist
     * @param model the NAO's limbs and hinges as JSON
     */
    public MotionApi(Path folder, JsonObject model) {
        this.motions = new MotionFolder(folder);
        this.own = new MotionFolder(folder.resolve(".studio"));
        this.drafts = new MotionFolder(folder.resolve(".studio").resolve("drafts"));
        this.robot = RobotDescription.write(model);
    }

    @Override
    protected Optional<Answer> answer(Request request, String path) throws IOException {
        return path.startsWith(PATH) ? Optional.of(reply(request, path)) : Optional.empty();
    }

    @Override
    protected String explain(IOException problem) {
        return explain("The file", motions.folder(), problem);
    }

    private Answer reply(Request request, String path) throws IOException {
        String order = request.getMethod() + " " + path;
        Matcher file = FILE.matcher(path);
        if (file.matches()) {
            String name = PathPart.decode(file.group(2));
            return fileAnswer(request, request.getMethod() + " " + file.group(1), name);
        }
        return switch (order) {
            case "GET /api/robot" -> Answer.json(robot);
            case "GET /api/motions" -> Answer.json(list());
            case "GET /api/poses" -> Answer.file(own.read(POSES).orElse(new byte[0]));
            case "PUT /api/poses" -> {
                own.overwrite(POSES, body(request));
                yield Answer.done();
            }
            case "POST /api/trial" -> Answer.json(trial(request));
            default -> throw new RefusedException(404, "Unknown request: " + order + ". Reload the page.");
        };
    }

    private Answer fileAnswer(Request request, String order, String name) throws IOException {
        return switch (order) {
            case "GET robot" -> Answer.json(RobotDescription.write(name));
            case "GET motions" -> Answer.file(found(motions.read(name), name));
            case "GET library" -> Answer.file(found(shipped(name), name));
            case "GET drafts" -> Answer.file(found(drafts.read(name), name));
            case "PUT motions" -> {
                String version = motions.write(name, body(request), knownVersion(request));
                yield Answer.written(version);
            }
            case "PUT drafts" -> {
                drafts.overwrite(name, body(request));
                yield Answer.done();
            }
            case "DELETE drafts" -> {
                drafts.remove(name);
                yield Answer.done();
            }
            default -> throw new RefusedException(405, "Method not allowed: " + order + ".");
        };
    }

    private static Optional<byte[]> shipped(String name) {
        ShippedMotions shipped = new ShippedMotions();
        return shipped.names().contains(name) ? shipped.read(name) : Optional.empty();
    }

    private static byte[] found(Optional<byte[]> content, String name) {
        return content.orElseThrow(() -> new RefusedException(404, "There is no motion named \"" + name + "\"."));
    }

    private static byte[] body(Request request) throws IOException {
        return body(request, MotionFiles.MAX_BYTES, "A motion file");
    }

    private String list() {
        JsonObject json = new JsonObject();
        json.addProperty("folder", motions.folder().toString());
        MotionFolder.Listing listing = motions.list();
        json.add("own", entries(listing.entries()));
        JsonArray leftOut = new JsonArray();
        listing.leftOut().forEach(leftOut::add);
        json.add("leftOut", leftOut);
        json.add("drafts", entries(drafts.list().entries()));
        JsonArray library = new JsonArray();
        new ShippedMotions().names().forEach(library::add);
        json.add("library", library);
        return json.toString();
    }

    private static JsonArray entries(List<PageFolder.Entry> entries) {
        JsonArray json = new JsonArray();
        for (PageFolder.Entry entry : entries) {
            JsonObject object = new JsonObject();
            object.addProperty("name", entry.path());
            object.addProperty("version", entry.version());
            json.add(object);
        }
        return json;
    }

    private static String trial(Request request) throws IOException {
        String start = Optional.ofNullable(request.getHeaders().get("Start")).orElse("standing");
        return PhysicalTrial.json(new String(body(request), StandardCharsets.UTF_8), start);
    }
}
