package org.robonewbie.examples;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * Plays a motion repeatedly while you edit it: save {@code motions/my-motion.txt} in the motion editor or any text editor, and
 * the robot plays the new version as soon as the current one has finished. If the robot falls, it gets up.
 *
 * <p>{@code Agent_KeyframeDeveloper my-kick} plays another file. A file that does not exist yet is created as a copy of {@code
 * wave}.
 */
public final class Agent_KeyframeDeveloper extends Agent {

    private static final double PAUSE_SECONDS = 2;
    private static final String DEFAULT_NAME = "my-motion";

    private FileTime played = FileTime.fromMillis(0);
    private double restSince;

    /** Creates the agent. */
    public Agent_KeyframeDeveloper() {}

    /**
     * Starts the robot.
     *
     * @param args name of the motion, and options
     */
    public static void main(String[] args) {
        new Agent_KeyframeDeveloper().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withWords().withPose(-1, 0, 0);
    }

    @Override
    protected void think() {
        if (!motions.isFinished()) {
            restSince = nao.getTime();
        } else if (nao.isFallen()) {
            motions.startGetUp();
        } else if (hasChanged() || nao.getTime() - restSince > PAUSE_SECONDS) {
            played = saved();
            motions.start(name());
        }
    }

    private boolean hasChanged() {
        return !saved().equals(played);
    }

    private String name() {
        return options().arguments().isEmpty()
                ? DEFAULT_NAME
                : options().arguments().get(0).replaceFirst("\\.txt$", "");
    }

    private FileTime saved() {
        Path file = Path.of("motions", name() + ".txt");
        try {
            if (!Files.exists(file)) {
                begin(file);
            }
            return Files.getLastModifiedTime(file);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static void begin(Path file) throws IOException {
        Files.createDirectories(file.toAbsolutePath().getParent());
        MotionFiles.save(ShippedMotions.file("wave"), file);
        System.out.println("Edit the new file " + file + " and save it: the robot plays each new version.");
    }
}
