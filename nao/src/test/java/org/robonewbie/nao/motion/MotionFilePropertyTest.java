package org.robonewbie.nao.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.lifecycle.AfterContainer;
import net.jqwik.api.lifecycle.BeforeContainer;
import org.robonewbie.nao.Joint;

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

    @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
    void everyMotionIsReadAsItWasWritten(@ForAll("motions") Motion motion) {
        MotionFile written = MotionFile.of(motion);

        MotionFile read = MotionFile.parse(written.name(), written.text());

        assertThat(read.errors()).isEmpty();
        assertThat(read.keyframes()).isEqualTo(motion.keyframes());
    }

    @Property
    void everyTextIsKeptToTheLetter(@ForAll("texts") String text) {
        assertThat(MotionFile.parse("a.txt", text).text()).isEqualTo(text);
    }

    @Property(tries = 200)
    void allBytesAreKept(@ForAll byte[] bytes) throws Exception {
        Files.write(file, bytes);

        MotionFile.load(file).save(file);

        assertThat(Files.readAllBytes(file)).isEqualTo(bytes);
    }

    @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
    void aChangedKeyframeIsReadAsChangedAndTheOthersStay(
            @ForAll("motions") Motion motion, @ForAll("keyframes") Keyframe keyframe, @ForAll int choice) {
        MotionFile original = MotionFile.of(motion);
        int index = Math.floorMod(choice, motion.keyframes().size());

        MotionFile changed = original.withKeyframe(index, keyframe);

        List<Keyframe> read = MotionFile.parse("a.txt", changed.text()).keyframes();
        assertThat(read).isEqualTo(changed.keyframes()).hasSameSizeAs(motion.keyframes());
        assertThat(read.get(index)).isEqualTo(keyframe);
        assertThat(changed.withKeyframe(index, motion.keyframes().get(index)).keyframes())
                .isEqualTo(motion.keyframes());
    }

    @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
    void insertingAndRemovingGivesTheSameTextAgain(
            @ForAll("motions") Motion motion, @ForAll("keyframes") Keyframe keyframe, @ForAll int choice) {
        MotionFile original = MotionFile.of(motion);
        int index = Math.floorMod(choice, motion.keyframes().size() + 1);

        MotionFile changed = original.withInsertedKeyframe(index, keyframe);

        assertThat(changed.keyframes().get(index)).isEqualTo(keyframe);
        assertThat(changed.withoutKeyframe(index).text()).isEqualTo(original.text());
    }

    @Provide
    Arbitrary<Motion> motions() {
        return keyframes().list().ofMinSize(1).ofMaxSize(6).map(keyframes -> new Motion("any", keyframes));
    }

    @Provide
    Arbitrary<Keyframe> keyframes() {
        Arbitrary<Double> angles = Arbitraries.oneOf(
                Arbitraries.doubles().between(-180, 180),
                Arbitraries.doubles().between(-1e9, 1e9).ofScale(12),
                Arbitraries.integers().between(-120, 120).map(Integer::doubleValue));
        return Combinators.combine(
                        Arbitraries.integers().between(-999_999_999, 999_999_999),
                        angles.array(double[].class).ofSize(Joint.COUNT))
                .as((millis, degrees) -> new Keyframe(millis, Posture.of(degrees)));
    }

    @Provide
    Arbitrary<String> texts() {
        return Arbitraries.strings()
                .withChars("0123456789.-+e \t\r\n/:aä\u2028\uFEFF")
                .ofMaxLength(200);
    }
}
