package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Printed;
import org.robonewbie.exercises.marking.HandIn;

/** A class without accounts has sent links and files from the web edition. */
class SentWorkTest {

    /** Has the same result, but is not a copy. */
    private static final String OTHER = """
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;

            public class RaiseArms extends Agent {
                private static final double GAIN = 3;

                @Override
                protected void think() {
                    double left = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
                    double right = nao.getJointAngle(Joint.RIGHT_SHOULDER_PITCH);
                    if (left < 59.9 || left > 60.1) {
                        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, GAIN * (60 - left));
                    } else {
                        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 0);
                    }
                    nao.setJointSpeed(Joint.RIGHT_SHOULDER_PITCH, GAIN * (45 - right));
                }
            }
            """;

    @TempDir
    private Path folder;

    private static HandIn work(String student, String program, String... exercises) {
        return new HandIn(student, 1, List.of(exercises), Map.of("RaiseArms.java", program));
    }

    private static byte[] packed(String json) throws IOException {
        return packed(json.getBytes(StandardCharsets.UTF_8));
    }

    private static byte[] packed(byte[] content) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (OutputStream packing = new GZIPOutputStream(bytes)) {
            packing.write(content);
        }
        return bytes.toByteArray();
    }

    private static String link(String json) throws IOException {
        return "https://robots.example/2026/class.html#submission="
                + Base64.getUrlEncoder().withoutPadding().encodeToString(packed(json));
    }

    /** Returns a link as some mail programs send it. */
    private static String encoded(String link) {
        int code = link.indexOf('=') + 1;
        return link.substring(0, code)
                + link.substring(code).replace("-", "%2D").replace("_", "%5F");
    }

    private void send(String file, byte[] bytes) throws IOException {
        Files.write(Files.createDirectories(folder.resolve("class")).resolve(file), bytes);
    }

    private Printed grade(Path... sources) {
        List<String> words = new java.util.ArrayList<>(List.of("grade", "raise-arms", "--seeds", "1", "--class"));
        for (Path source : sources) {
            words.add(source.toString());
        }
        return Printed.by(words.toArray(String[]::new));
    }

    @Test
    void classOfFiveComesIntoTheTable() throws IOException {
        String anna = work("Anna", ClassMarkingTest.GOOD, "raise-arms").json();
        send("Anna.robonewbie", packed(anna));
        send(
                "Ben.robonewbie",
                packed(work("Ben", ClassMarkingTest.GOOD.replace("hold", "raise"), "raise-arms")
                        .json()));
        String cora = link(work("Cora", OTHER, "raise-arms", "fly-to-the-moon").json());
        String damaged = cora.substring(0, cora.length() / 2);
        String dora = link(work("Dora", ClassMarkingTest.GOOD, "raise-arms").json());
        String other = link(work("dora", OTHER, "raise-arms").json());
        send(
                "links.txt",
                String.join("\n", "Here are mine:", encoded(cora), "", damaged, dora, "<" + other + ">", link(anna))
                        .getBytes(StandardCharsets.UTF_8));

        Printed printed = grade(folder.resolve("class"));

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        Path results = folder.resolve("class-grades");
        assertThat(Files.readAllLines(results.resolve("grades.csv")))
                .containsExactly(
                        "student,01-raise-arms,points,passed,note",
                        "Anna,10.0,10.0,1,",
                        "Ben,10.0,10.0,1,",
                        "Cora,10.0,10.0,1,This version has no exercise named fly-to-the-moon.",
                        "Dora,,,,\"The name occurs 2 times: links.txt, line 5; links.txt, line 6. None of them was"
                                + " graded; remove all but one.\"",
                        "\"links.txt, line 4\",,,,It is incomplete or damaged. Ask for it again.");
        assertThat(Files.readString(results.resolve("copies.csv")))
                .contains("Anna,Ben")
                .doesNotContain("Cora");
    }

    @Tag("slow")
    @Test
    void nameOfAFolderIsNotTakenASecondTime() throws IOException {
        Path own = Files.createDirectories(folder.resolve("class/anna"));
        Files.writeString(own.resolve("RaiseArms.java"), ClassMarkingTest.GOOD);
        send(
                "a.robonewbie",
                packed(work("Anna", "class RaiseArms {}", "raise-arms").json()));

        grade(folder.resolve("class"));

        assertThat(Files.readString(folder.resolve("class-grades/grades.csv")))
                .contains("anna,10.0,10.0,1,", "Anna,,,,There is another submission with this name");
    }

    @Test
    void hostileFilesAreRefusedAndTheOthersCount() throws IOException {
        String good = work("Anna", OTHER, "raise-arms").json();
        send("anna.robonewbie", packed(good));
        send("outside.robonewbie", packed(good.replace("RaiseArms.java", "../../RaiseArms.java")));
        send("name.robonewbie", packed(good.replace("Anna", "..")));
        send("large.robonewbie", packed(" ".repeat(50_000_000)));
        send("next.robonewbie", packed(good.replace("\"version\":1", "\"version\":2")));
        send("noise.robonewbie", "noise".getBytes(StandardCharsets.UTF_8));
        send("list.robonewbie", packed("[1]"));
        send("latin.robonewbie", packed(good.replace("Anna", "J\u00f6rg").getBytes(StandardCharsets.ISO_8859_1)));

        grade(folder.resolve("class"));

        assertThat(Files.readAllLines(folder.resolve("class-grades/grades.csv")))
                .containsExactly(
                        "student,01-raise-arms,points,passed,note",
                        "Anna,10.0,10.0,1,",
                        "large.robonewbie,,,,It is larger than 1 MB unpacked.",
                        "latin.robonewbie,,,,It is incomplete or damaged. Ask for it again.",
                        "list.robonewbie,,,,It is incomplete or damaged. Ask for it again.",
                        "name.robonewbie,,,,\"The name \"\"..\"\" begins with a dot. Choose another name.\"",
                        "next.robonewbie,,,,It was made by another version of RoboNewbie (format 2; this version reads"
                                + " format 1). Install the newest version.",
                        "noise.robonewbie,,,,It is incomplete or damaged. Ask for it again.",
                        "outside.robonewbie,,,,\"The file name \"\"../../RaiseArms.java\"\" contains \"\"/\"\". Choose"
                                + " another name.\"");
    }

    @Tag("slow")
    @Test
    void singleFilesAreGradedAndOthersAreNamed() throws IOException {
        send(
                "anna.robonewbie",
                packed(work("Anna", ClassMarkingTest.GOOD, "raise-arms").json()));
        send("notes.txt", "no link".getBytes(StandardCharsets.UTF_8));
        Path sent = folder.resolve("class");

        Printed printed = grade(sent.resolve("anna.robonewbie"), sent.resolve("notes.txt"));
        Printed missing = grade(sent.resolve("nothing.robonewbie"));

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(Files.readString(sent.resolve("class-grades/grades.csv")))
                .contains("Anna,10.0,10.0,1,", "notes.txt,,,,It contains no submission.");
        assertThat(missing.exitCode()).isEqualTo(2);
        assertThat(missing.err()).contains("There is no file or folder").contains("nothing.robonewbie");
    }
}
