package org.robonewbie.learning.optimise;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.MotionFiles;

/** Makes the left-hand file of a right-hand motion and vice versa. */
public final class OtherSide {

    private static final Pattern SIDE = Pattern.compile("\\b(left|right)\\b");
    private static final List<String> WORDS = List.of("does", "start", "end");

    private OtherSide() {}

    /**
     * Returns where the mirror image of a motion belongs.
     *
     * @param file a motion file such as {@code kick-right.txt}
     * @return the file next to it with the other side in its name, such as {@code kick-left.txt}
     * @throws IllegalArgumentException if the name does not say which side it is
     */
    public static Path of(Path file) {
        String name = String.valueOf(file.getFileName());
        if (!SIDE.matcher(name).find()) {
            throw new IllegalArgumentException(
                    "--both-sides needs an output with left or right in its name, not " + name + ".");
        }
        return file.resolveSibling(exchanged(name));
    }

    /**
     * Writes the mirror image of a motion next to it.
     *
     * @param file a motion file such as {@code kick-right.txt}
     * @throws IOException if a file cannot be read or written
     */
    public static void write(Path file) throws IOException {
        MotionFile mirrored = MotionFiles.load(file);
        int index = 0;
        for (Keyframe keyframe : mirrored.keyframes()) {
            mirrored = mirrored.withKeyframe(
                    index++,
                    new Keyframe(keyframe.durationMillis(), keyframe.posture().mirrored()));
        }
        for (String key : WORDS) {
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
