package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.marking.HandIn;
import org.robonewbie.web.Solutions;

/** A class without accounts in the static page: the teacher's link, the pupils' submissions, and the table. */
@Tag("slow")
@InBrowser
@Timeout(600)
class ClassInThePageTest {

    private static final Exercise RAISE_ARMS = Exercises.find("raise-arms").orElseThrow();
    private static final String FILE = "RaiseArms.java";

    /** Long enough to be compared with others. */
    private static final String GOOD = """
            import org.robonewbie.agent.Agent;
            import org.robonewbie.nao.Joint;

            public class RaiseArms extends Agent {
                @Override
                protected void think() {
                    hold(Joint.LEFT_SHOULDER_PITCH, 60);
                    hold(Joint.RIGHT_SHOULDER_PITCH, 45);
                }

                private void hold(Joint joint, double degrees) {
                    double error = degrees - nao.getJointAngle(joint);
                    double speed = Math.max(-100, Math.min(100, 4 * error));
                    nao.setJointSpeed(joint, Math.abs(error) < 0.2 ? 0 : speed);
                }
            }
            """;

    @TempDir
    private Path folder;

    private final Chromium browser;
    private StaticServer server;

    ClassInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void serve() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
    }

    @AfterEach
    void end() {
        server.close();
    }

    @Test
    void teacherChoosesExercisesForALink() {
        browser.visit(server.address() + "#field/exercises");
        browser.await("document.querySelectorAll('.class-exercises input').length > 20");
        browser.click(".class-exercises [value='stop-at-30']");
        browser.click(".class-exercises [value='raise-arms']");
        browser.fill("#class-trials", "10");

        assertThat(value("#class-link"))
                .isEqualTo(server.address() + "#exercises?class=raise-arms,stop-at-30&seeds=10");
    }

    @Test
    void pupilSendsALinkThatJavaReads() throws IOException {
        openAssignment();
        browser.await("document.querySelector('#class-state').innerText === 'RaiseArms.java: not begun yet\\n"
                + "StopAt30.java: not begun yet'");
        assertThat(browser.evaluate("[...document.querySelectorAll('.lessons button')].filter((each) =>"
                                + " each.offsetParent).map((each) => each.dataset.exercise).join()")
                        .getAsString())
                .isEqualTo("raise-arms,stop-at-30");
        browser.click("#class-send");
        said("Write your name first.");
        browser.fill("#class-name", "../Anna");
        browser.click("#class-send");
        said("There is no saved program for these exercises yet.");
        store("programs/own/" + FILE, Solutions.text(RAISE_ARMS) + "\n// Helper.of(\"bow\") grüßt\n");
        store("programs/own/Other.java", "public class Helper {}");
        store("programs/own/Unused.java", "public class Unused {}");
        store("motions/bow", "motion\n");
        browser.click("#class-send");
        said("The name \"../Anna\" contains \"/\". Choose another name.");
        browser.fill("#class-name", " Anna ");
        browser.click("#class-send");
        browser.await("document.querySelector('#class-submission').value !== ''");

        String link = value("#class-submission");
        assertThat(link).startsWith(server.address() + "class.html#submission=");
        assertThat(unpacked(link))
                .isEqualTo(new HandIn(
                        "Anna",
                        1,
                        List.of("raise-arms", "stop-at-30"),
                        Map.of(
                                FILE,
                                Solutions.text(RAISE_ARMS) + "\n// Helper.of(\"bow\") grüßt\n",
                                "Helper.java",
                                "public class Helper {}",
                                "motions/bow.txt",
                                "motion\n")));
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void longSubmissionIsAFile() throws IOException {
        openAssignment();
        StringBuilder text = new StringBuilder(Solutions.text(RAISE_ARMS));
        for (int i = 0; i < 900; i++) {
            text.append("// ").append(i * 7919).append('\n');
        }
        store("programs/own/" + FILE, text.toString());
        browser.fill("#class-name", "Zoë");

        Path file = browser.download(folder, () -> browser.click("#class-send"));

        assertThat(file).hasFileName("Zoë.robonewbie");
        try (InputStream in = new GZIPInputStream(Files.newInputStream(file))) {
            assertThat(HandIn.parse(new String(in.readAllBytes(), StandardCharsets.UTF_8))
                            .files())
                    .containsEntry(FILE, text.toString());
        }
    }

    @Test
    void classOfFiveIsGradedInThePage() throws IOException {
        String copy = GOOD.replace("hold", "raise").replace("error", "rest");
        String broken = GOOD.replace("60);", "60)");
        String cora = link(new HandIn("Cora", 1, List.of("raise-arms", "fly-to-the-moon"), Map.of(FILE, broken)));
        String dora = link(work("Dora", GOOD));
        browser.visit(server.address() + "class.html#" + link(work("Anna", GOOD)).replaceFirst(".*#", ""));
        browser.await("document.querySelector('#class-count').innerText === '1 student, 1 program'");
        browser.fill(
                "#class-links",
                String.join(
                        "\n",
                        link(work("Ben", copy)),
                        cora,
                        cora.substring(0, cora.length() / 2),
                        dora,
                        link(work("dora", copy))));
        browser.await("document.querySelector('#class-count').innerText === '4 students, 3 programs'");
        assertThat(browser.evaluate("document.querySelector('#class-unreadable').innerText").getAsString())
                .startsWith("Could not be read").contains("pasted, line 3: It is incomplete or damaged.");
        browser.click("#class-grade");
        browser.await("document.querySelector('#class-progress').innerText.startsWith('4 students, 3 programs.')");

        Path csv = browser.download(
                folder,
                () -> browser.clickElement("[...document.querySelectorAll('#class-saving button')].find((each) =>"
                        + " each.innerText === 'Save grades.csv')"));
        assertThat(Files.readAllLines(csv))
                .satisfiesExactly(
                        line -> assertThat(line).isEqualTo("student,01-raise-arms,points,passed,note"),
                        line -> assertThat(line).isEqualTo("Anna,10.0,10.0,1,"),
                        line -> assertThat(line).isEqualTo("Ben,10.0,10.0,1,"),
                        line -> assertThat(line)
                                .isEqualTo("Cora,0.0,0.0,0,This version has no exercise named fly-to-the-moon. raise-arms: It"
                                        + " does not compile: RaiseArms.java:7: ';' expected"),
                        line -> assertThat(line)
                                .isEqualTo("Dora,,,,\"The name occurs 2 times: pasted, line 4; pasted, line 5. None of"
                                        + " them was graded; remove all but one.\""),
                        line -> assertThat(line)
                                .isEqualTo(
                                        "\"pasted, line 3\",,,,It is incomplete or damaged. Ask for it again."));
        browser.await("document.querySelector('#class-table').contentDocument.body.innerText.includes('Anna')");
        assertThat(browser.evaluate("document.querySelector('#class-table').contentDocument.body.innerText")
                        .getAsString())
                .contains("Dora\tnot graded");
        assertThat(browser.evaluate("document.querySelector('#class-table').contentDocument.body.innerText")
                        .getAsString())
                .contains("3 pairs of programs are alike", "01-raise-arms\tAnna\tBen\t100 %");
        browser.clickElement("[...document.querySelectorAll('#class-students li')].find((each) =>"
                + " each.innerText.startsWith('Dora (pasted, line 5)')).querySelector('button')");
        browser.await("document.querySelector('#class-count').innerText === '4 students, 4 programs'");
        assertThat(browser.complaints()).isEmpty();
    }

    private static HandIn work(String student, String program) {
        return new HandIn(student, 1, List.of(RAISE_ARMS.name()), Map.of(FILE, program));
    }

    private void openAssignment() {
        browser.visit(server.address() + "#exercises?class=raise-arms,stop-at-30&seeds=1");
        browser.await("document.querySelectorAll('.lessons button').length > 20");
    }

    private void store(String place, String text) {
        browser.evaluate("fetch('api/" + place + "', { method: 'PUT', body: " + Chromium.quoted(text)
                + " }).then(({ ok }) => ok)");
    }

    private String value(String selector) {
        return browser.evaluate("document.querySelector('" + selector + "').value")
                .getAsString();
    }

    private void said(String sentence) {
        browser.await("document.querySelector('#class-said').innerText.startsWith(" + Chromium.quoted(sentence) + ")");
    }

    private String link(HandIn work) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (OutputStream packing = new GZIPOutputStream(bytes)) {
            packing.write(work.json().getBytes(StandardCharsets.UTF_8));
        }
        return server.address() + "class.html#submission="
                + Base64.getUrlEncoder().withoutPadding().encodeToString(bytes.toByteArray());
    }

    private static HandIn unpacked(String link) throws IOException {
        byte[] packed = Base64.getUrlDecoder().decode(link.replaceFirst(".*=", ""));
        try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(packed))) {
            return HandIn.parse(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }
    }
}
