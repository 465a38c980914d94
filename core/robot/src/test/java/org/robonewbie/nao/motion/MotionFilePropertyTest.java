package org.robonewbie.nao.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.lifecycle.AfterContainer;
import net.jqwik.api.lifecycle.BeforeContainer;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.file.MotionFiles;

class MotionFilePropertyTest {

    private static Path file = Path.of("");

    @BeforeContainer
    static void createFile() throws Exception {
        file = Files.createTempFile("motion", ".txt");
    }

    @AfterContainer
    static void deleteFile() throws Exception {
        Files.delete(file);
    }

    @Property(tries = 200)
    void everyMotionIsReadAsItWasWritten(@ForAll long seed) {
        Motion motion = motion(new Random(seed));
        MotionFile written = MotionFile.of(motion);

        MotionFile read = MotionFile.parse(written.name(), written.text());

        assertThat(read.errors()).isEmpty();
        assertThat(read.keyframes()).isEqualTo(motion.keyframes());
    }

    @Property(tries = 200)
    void everyTextIsKeptToTheLetter(@ForAll("texts") String text) {
        assertThat(MotionFile.parse("a.txt", text).text()).isEqualTo(text);
    }

    @Property(tries = 50)
    void allBytesAreKept(@ForAll byte[] bytes) throws Exception {
        Files.write(file, bytes);

        MotionFiles.save(MotionFiles.load(file), file);

        assertThat(Files.readAllBytes(file)).isEqualTo(bytes);
    }

    @Property(tries = 200)
    void aChangedKeyframeIsReadAsChangedAndTheOthersStay(@ForAll long seed, @ForAll int choice) {
        Random random = new Random(seed);
        Motion motion = motion(random);
        Keyframe keyframe = keyframe(random);
        MotionFile original = MotionFile.of(motion);
        int index = Math.floorMod(choice, motion.keyframes().size());

        MotionFile changed = original.withKeyframe(index, keyframe);

        List<Keyframe> read = MotionFile.parse("a.txt", changed.text()).keyframes();
        assertThat(read).isEqualTo(changed.keyframes()).hasSameSizeAs(motion.keyframes());
        assertThat(read.get(index)).isEqualTo(keyframe);
        assertThat(changed.withKeyframe(index, motion.keyframes().get(index)).keyframes())
                .isEqualTo(motion.keyframes());
    }

    @Provide
    Arbitrary<String> texts() {
        return Arbitraries.strings()
                .withChars("0123456789.-+e \t\r\n/:aä\u2028\uFEFF")
                .ofMaxLength(200);
    }

    private static Motion motion(Random random) {
        int count = 1 + random.nextInt(6);
        return new Motion(
                "any", Stream.generate(() -> keyframe(random)).limit(count).toList());
    }

    private static Keyframe keyframe(Random random) {
        double[] degrees = random.doubles(Joint.COUNT)
                .map(fraction -> angle(random, fraction))
                .toArray();
        return new Keyframe(random.nextInt(-999_999_999, 999_999_999), Posture.of(degrees));
    }

    /** Whole, with two decimals, with all digits, tiny or huge. */
    private static double angle(Random random, double fraction) {
        double degrees = 360 * fraction - 180;
        return switch (random.nextInt(5)) {
            case 0 -> Math.rint(degrees);
            case 1 -> Math.rint(100 * degrees) / 100;
            case 2 -> degrees;
            case 3 -> degrees * 1e-9;
            default -> degrees * 1e12;
        };
    }
}
