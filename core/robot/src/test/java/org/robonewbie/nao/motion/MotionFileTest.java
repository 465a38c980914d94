package org.robonewbie.nao.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.motion.file.MotionFiles;

class MotionFileTest {

    private static final String ZEROS = " 0".repeat(22);

    @TempDir
    private Path folder;

    @Test
    void readsTimesAndAnglesInTheOrderOfTheJoints() {
        MotionFile file = MotionFile.parse(
                "wave.txt", "// made by hand\n\n500 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22.5\n");

        Motion motion = file.motion();

        assertThat(motion.name()).isEqualTo("wave");
        assertThat(motion.keyframes()).hasSize(1);
        assertThat(motion.keyframes().get(0).durationMillis()).isEqualTo(500);
        assertThat(motion.keyframes().get(0).posture().degrees(Joint.NECK_YAW)).isEqualTo(1);
        assertThat(motion.keyframes().get(0).posture().degrees(Joint.RIGHT_ARM_YAW))
                .isEqualTo(22.5);
    }

    @Test
    void takesBlanksTabsCommentsAndEveryLineEnd() {
        String text = "\t 100" + ZEROS + " \r\n//c\r200\t" + ZEROS + "// crouch\n   \n300" + ZEROS;

        MotionFile file = MotionFile.parse("a.txt", text);

        assertThat(file.errors()).isEmpty();
        assertThat(file.keyframes()).extracting(Keyframe::durationMillis).containsExactly(100, 200, 300);
        assertThat(file.text()).isEqualTo(text);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "\n\n",
                "// only a comment",
                "\uFEFF// byte order mark\r\n500 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0.50\r\n",
                "0500 -0 +1.0 1. .5 1e1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 00.10",
                "nonsense\n// grüße\n500"
            })
    void savesWhatItLoadedToTheLetter(String text) throws IOException {
        Path original = folder.resolve("original.txt");
        Path copy = folder.resolve("copy.txt");
        Files.writeString(original, text);

        MotionFiles.save(MotionFiles.load(original), copy);

        assertThat(copy).hasSameBinaryContentAs(original);
    }

    @Test
    void keepsTheBytesOfOldLatinFiles() throws IOException {
        Path original = folder.resolve("original.txt");
        Path copy = folder.resolve("copy.txt");
        Files.write(original, ("// Grüße\n100" + ZEROS).getBytes(StandardCharsets.ISO_8859_1));

        MotionFile file = MotionFiles.load(original);
        MotionFiles.save(file, copy);

        assertThat(copy).hasSameBinaryContentAs(original);
        assertThat(file.text()).startsWith("// Grüße");
    }

    @Test
    void replacesAFileAndLeavesNoOther() throws IOException {
        Path path = folder.resolve("walk.txt");
        Files.writeString(path, "old");

        MotionFiles.save(MotionFile.of(new Motion("walk", List.of(new Keyframe(100, Posture.ZERO)))), path);

        assertThat(path).hasContent("100" + ZEROS);
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).containsExactly(path);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "200 ZEROS LF // x 81,2,neither UTF-8 nor Windows-1252 (byte 0x81)",
        "00 01 02,1,zero byte",
        "FFFE 41 00 0D 00 0A 00 00 D8 41 00,2,ends within a UTF-16 character",
        "C3BC LF C3BC LF C3BC FF,3,it is damaged"
    })
    void bytesThatAreNoTextAreAnErrorOfTheirLineAndStay(String parts, int line, String problem) {
        byte[] bytes = HexFormat.of()
                .parseHex(parts.replace("// x", "2F2F78")
                        .replace("ZEROS", HexFormat.of().formatHex(ZEROS.getBytes(StandardCharsets.UTF_8)))
                        .replace("200", "323030")
                        .replace("LF", "0A")
                        .replace(" ", ""));

        MotionFile file = MotionFile.parse("odd.txt", bytes);

        assertThat(file.errors()).singleElement().satisfies(error -> {
            assertThat(error.line()).isEqualTo(line);
            assertThat(error.text()).contains(problem).endsWith("Save it as UTF-8 (most editors: Save As, Encoding).");
        });
        assertThat(file.bytes()).isEqualTo(bytes);
        assertThatThrownBy(file::motion)
                .isInstanceOf(MotionFormatException.class)
                .hasMessageStartingWith("odd.txt line " + line + ", column 1: ");
        assertThatThrownBy(() -> file.withProperty("author", "Ada")).isInstanceOf(MotionFormatException.class);
    }

    @ParameterizedTest
    @CsvSource({"UTF-16LE,FFFE", "UTF-16BE,FEFF", "UTF-8,EFBBBF", "UTF-8,''", "windows-1252,''"})
    void motionIsReadAsEditorsSaveItAndKeepsItsEncoding(String charset, String mark) {
        String text = "// für Zoë\r\n200" + ZEROS + "\r\n";
        byte[] bytes = joined(mark, text, charset);

        MotionFile file = MotionFile.parse("nod.txt", bytes);

        assertThat(file.errors()).isEmpty();
        assertThat(file.keyframes()).hasSize(1);
        assertThat(file.bytes()).isEqualTo(bytes);
        assertThat(file.withProperty("author", "Zoë").bytes())
                .isEqualTo(joined(mark, "// author: Zoë\r\n" + text, charset));
    }

    private static byte[] joined(String mark, String text, String charset) {
        byte[] content = text.getBytes(Charset.forName(charset));
        return HexFormat.of().parseHex(mark + HexFormat.of().formatHex(content));
    }

    @Test
    void saysWhichFileIsMissing() {
        assertThatThrownBy(() -> MotionFiles.load(folder.resolve("missing.txt")))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageContaining("missing.txt does not exist");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "500 1 2 3 | line 2, column 10: 3 angles, expected 22: write one angle in degrees for each joint"
                        + " after the time in milliseconds",
                "500 | line 2, column 4: 0 angles, expected 22: write one angle in degrees for each joint"
                        + " after the time in milliseconds",
                "half 1 2 | line 2, column 1: found \"half\", expected the time in whole milliseconds, such as 500",
                "1.5 1 2 | line 2, column 1: found \"1.5\", expected the time in whole milliseconds, such as 500",
                "99999999999 1 | line 2, column 1: found \"99999999999\", expected the time in whole milliseconds, such as 500",
                "500 1 NaN | line 2, column 7: found \"NaN\", expected the angle of NECK_PITCH in degrees, such as -12.5",
                "500 1,5 | line 2, column 5: found \"1,5\", expected the angle of NECK_YAW in degrees, such as -12.5",
                "500 1e999 | line 2, column 5: found \"1e999\", expected the angle of NECK_YAW in degrees, such as -12.5",
                "500 0x1F | line 2, column 5: found \"0x1F\", expected the angle of NECK_YAW in degrees, such as -12.5",
                "500 1d | line 2, column 5: found \"1d\", expected the angle of NECK_YAW in degrees, such as -12.5",
                "500 1 / | line 2, column 7: found \"/\", expected the angle of NECK_PITCH in degrees, such as -12.5"
            })
    void refusesALineWithPlaceAndReason(String line, String message) {
        MotionFile file = MotionFile.parse("walk.txt", "100" + ZEROS + "\n" + line);

        assertThatThrownBy(file::motion)
                .isInstanceOf(MotionFormatException.class)
                .hasMessage("walk.txt " + message);
        assertThat(file.errors()).extracting(MotionProblem::toString).containsExactly(message);
        assertThat(file.text()).endsWith(line);
    }

    @Test
    void refusesTooManyAngles() {
        MotionFile file = MotionFile.parse("walk.txt", "100" + ZEROS + " 7");

        assertThatThrownBy(file::motion)
                .isInstanceOf(MotionFormatException.class)
                .hasMessageStartingWith("walk.txt line 1, column 49: 23 angles, expected 22");
    }

    @Test
    void refusesAFileWithoutKeyframes() {
        MotionFile file = MotionFile.parse("walk.txt", "// nothing yet\n");

        assertThatThrownBy(file::motion)
                .isInstanceOf(MotionFormatException.class)
                .hasMessage("walk.txt line 2, column 1: no keyframe, expected at least one line with a time in"
                        + " milliseconds and 22 angles");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0 | time 0 ms is not positive, expected at least 20",
                "-20 | time -20 ms is not positive, expected at least 20",
                "30 | time 30 ms is not a multiple of the robot's cycle of 20 ms and will be rounded",
                "60020 | time 60020 ms is longer than a minute; times are in milliseconds"
            })
    void warnsOfOddTimes(String time, String warning) {
        MotionFile file = MotionFile.parse("walk.txt", "// c\n  " + time + ZEROS);

        assertThat(file.warnings()).containsExactly(new MotionProblem(2, 3, warning));
        assertThat(file.motion().keyframes()).hasSize(1);
    }

    @Test
    void warnsOfAnglesBeyondTheRange() {
        MotionFile file = MotionFile.parse("walk.txt", "100 0 -60.50" + " 0".repeat(20));

        assertThat(file.warnings())
                .containsExactly(new MotionProblem(
                        1, 7, "angle -60.50 is beyond the range of NECK_PITCH, expected -45.0 to 45.0 degrees"));
        assertThat(file.motion().keyframes().get(0).posture().degrees(Joint.NECK_PITCH))
                .isEqualTo(-60.5);
    }

    @Test
    void doesNotWarnOfAGoodFile() {
        assertThat(MotionFile.parse("walk.txt", "20" + ZEROS + "\n60000" + ZEROS)
                        .warnings())
                .isEmpty();
    }

    @Test
    void keepsFactsInComments() {
        MotionFile file = MotionFile.parse("walk.txt", "// author: Ada\n//loop:yes\n// a plain comment\n100" + ZEROS);

        assertThat(file.property("author")).contains("Ada");
        assertThat(file.property("loop")).contains("yes");
        assertThat(file.property("plain")).isEmpty();
    }

    @Test
    void changesAFactInItsPlace() {
        MotionFile file = MotionFile.parse("walk.txt", "// top\r\n// author: Ada\r\n100" + ZEROS);

        MotionFile changed = file.withProperty("author", "Grace").withProperty("loop", "no");

        assertThat(changed.text()).isEqualTo("// loop: no\r\n// top\r\n// author: Grace\r\n100" + ZEROS);
        assertThat(file.property("author")).contains("Ada");
    }

    @Test
    void readsWhereTheBallLiesAndWritesItBack() {
        MotionFile kick = MotionFile.parse("kick.txt", "// ball: 0.190 m ahead, -0.055 m to the left");

        assertThat(kick.ball()).contains(new Translation2d(0.19, -0.055));
        assertThat(kick.withBall(kick.ball().orElseThrow()).text()).isEqualTo(kick.text());
        assertThat(MotionFile.parse("wave.txt", "// ball: none").ball()).isEmpty();
    }

    @Test
    void changesNothingButTheNumbersThatChange() {
        MotionFile file = MotionFile.parse("walk.txt", "// a\n0100\t1.50  2.0" + " 0".repeat(20) + " // crouch\n");
        Keyframe before = file.keyframes().get(0);

        MotionFile changed =
                file.withKeyframe(0, new Keyframe(120, before.posture().with(Joint.NECK_YAW, -3.25)));
        MotionFile same = file.withKeyframe(0, before);

        assertThat(changed.text()).isEqualTo("// a\n120\t-3.25  2.0" + " 0".repeat(20) + " // crouch\n");
        assertThat(same.text()).isEqualTo(file.text());
    }

    @Test
    void saysWhichKeyframeIsMissing() {
        MotionFile file = MotionFile.parse("walk.txt", "100" + ZEROS);

        assertThatThrownBy(() -> file.withKeyframe(1, new Keyframe(20, Posture.ZERO)))
                .isInstanceOf(IndexOutOfBoundsException.class)
                .hasMessage("walk.txt has 1 keyframes, so there is no keyframe 1.");
    }

    @Test
    void editsAroundALineThatItCannotRead() {
        MotionFile file = MotionFile.parse("walk.txt", "100" + ZEROS + "\noops\n200" + ZEROS);

        MotionFile changed = file.withKeyframe(1, new Keyframe(300, Posture.ZERO));

        assertThat(changed.text()).isEqualTo("100" + ZEROS + "\noops\n300" + ZEROS);
    }

    @Test
    void writesMotionsOnOneLinePerKeyframe() {
        double[] degrees = new double[Joint.COUNT];
        Arrays.fill(degrees, -0.5);
        Motion motion =
                new Motion("nod", List.of(new Keyframe(100, Posture.of(degrees)), new Keyframe(20, Posture.ZERO)));

        assertThat(MotionFile.of(motion).text()).isEqualTo("100" + " -0.5".repeat(22) + "\n20" + ZEROS + "\n");
        assertThat(MotionFile.of(motion).name()).isEqualTo("nod.txt");
    }

    @Test
    void namesTheFileAsTheMotion() {
        String lines = Stream.of(1, 2).map(i -> "100" + ZEROS).collect(Collectors.joining("\n"));

        assertThat(MotionFile.parse("turn-left.v2.txt", lines).motion().name()).isEqualTo("turn-left.v2");
        assertThat(MotionFile.parse("turn", lines).motion().name()).isEqualTo("turn");
    }
}
