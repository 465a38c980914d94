package org.robonewbie.studio.motion;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import org.eclipse.jetty.server.Request;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.studio.file.Answer;
import org.robonewbie.studio.file.ApiHandler;
import org.robonewbie.studio.file.PageFiles;
import org.robonewbie.studio.file.ShippedFiles;
import org.robonewbie.studio.service.PageRequest;

/** HTTP endpoint for the motion editor: the robots, and trials with physics. The files are those of {@link #files}. */
public final class MotionApi extends ApiHandler {

    private final Path folder;
    private final String robot;

    /**
     * Creates the endpoint.
     *
     * @param folder folder of the motion files; it need not exist
     * @param model the NAO's limbs and hinges as JSON
     */
    public MotionApi(Path folder, JsonObject model) {
        super(EnumSet.range(PageRequest.NAO, PageRequest.TRY_MOTION));
        this.folder = folder;
        this.robot = RobotDescription.write(model);
    }

    /** {@return the files of the motion editor by the name of their kind} */
    public Map<String, PageFiles> files() {
        MotionFolder motions = MotionFolder.of(folder);
        ShippedMotions shipped = new ShippedMotions();
        return Map.of(
                "motion",
                motions,
                "motion-draft",
                motions.drafts().orElseThrow(),
                "motion-library",
                new ShippedFiles("motion", shipped.names(), shipped::read),
                "postures",
                MotionFolder.postures(folder));
    }

    @Override
    protected Answer answer(PageRequest asked, List<String> path, Request request) throws IOException {
        return Answer.json(
                switch (asked) {
                    case ROBOT -> RobotDescription.write(path.get(1));
                    case TRY_MOTION -> trial(request);
                    default -> robot;
                });
    }

    @Override
    protected String explain(IOException problem) {
        return explain("The file", "the folder " + folder, problem);
    }

    private static String trial(Request request) throws IOException {
        String start = header(request, "Start");
        byte[] motion = body(request, MotionFiles.MAX_BYTES, "A motion file");
        return PhysicalTrial.json(new String(motion, StandardCharsets.UTF_8), start.isEmpty() ? "standing" : start);
    }
}
