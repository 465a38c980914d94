package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;

/** Mirror image of a motion file: the left variant of a right motion, and vice versa. */
public final class OtherSide {

    private static final Pattern SIDE = Pattern.compile("\\b(left|right)\\b");
    private static final List<String> SIDED_PROPERTIES = List.of("does", "start", "end");

    private OtherSide() {}

    /**
     * Returns the file of the mirror image.
     *
     * @param file a motion file such as {@code kick-right.txt}
     * @return the file beside it with the other side in its name, such as {@code kick-left.txt}
     * @throws IllegalArgumentException if the name contains neither left nor right
     */
    public static Path of(Path file) {
        String name = String.valueOf(file.getFileName());
        if (!SIDE.matcher(name).find()) {
            throw new IllegalArgumentException(
                    "--both-sides needs an output file whose name contains left or right, not " + name + ".");
        }
        return file.resolveSibling(exchanged(name));
    }

    /**
     * Writes the mirror image of a motion to a file beside it.
     *
     * @param file a motion file such as {@code kick-right.txt}
     * @throws IOException if a file cannot be read or written
     */
    public static void write(Path file) throws IOException {
        MotionFile mirrored = MotionFiles.load(file);
        mirrored = mirrored.withKeyframes(mirrored.motion().mirrored().keyframes());
        for (String key : SIDED_PROPERTIES) {
            if (mirrored.property(key).isPresent()) {
                mirrored = mirrored.withProperty(
                        key, exchanged(mirrored.property(key).get()));
            }
        }
        Optional<Translation2d> ball = mirrored.ball();
        if (ball.isPresent()) {
            mirrored = mirrored.withBall(
                    new Translation2d(ball.get().x(), -ball.get().y()));
        }
        if (mirrored.property("made by").isPresent()) {
            mirrored = mirrored.withProperty(
                    "made by", mirrored.property("made by").get() + " --both-sides");
        }
        MotionFiles.save(mirrored, of(file));
    }

    private static String exchanged(String text) {
        return SIDE.matcher(text).replaceAll(side -> side.group().equals("left") ? "right" : "left");
    }
}
