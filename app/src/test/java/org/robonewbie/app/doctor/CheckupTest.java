package org.robonewbie.app.doctor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.math.MathFingerprint;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

class CheckupTest {

    @Test
    void healthyComputerHasNoFailures() {
        List<Finding> findings = StreamSupport.stream(
                        Checkup.of(false).findings().spliterator(), false)
                .toList();

        assertThat(findings).hasSize(13).noneMatch(finding -> finding.verdict() == Verdict.BROKEN);
    }

    @Test
    void encodingProblemIsReportedWithAdvice() {
        assertThat(EncodingCheck.of(Optional.empty(), true, "UTF-8").verdict()).isEqualTo(Verdict.WELL);
        assertThat(EncodingCheck.of(Optional.empty(), false, "ANSI_X3.4-1968").toText())
                .startsWith("look  Encoding")
                .contains("ANSI_X3.4-1968", "export LC_ALL=C.UTF-8");
        assertThat(EncodingCheck.of(Optional.of("The name is lost."), false, "x")
                        .toText())
                .startsWith("FAIL  Encoding       The name is lost.");
    }

    @Test
    void headlessCheckupSkipsStudioAndBrowser() {
        assertThat(Checkup.of(true).findings())
                .extracting(Finding::subject)
                .contains("Simulator")
                .doesNotContain("Studio", "Browser");
    }

    @Test
    void robotStandsForOneSecond() {
        Finding finding = SimulatorCheck.oneSecond();

        assertThat(finding.verdict()).isEqualTo(Verdict.WELL);
        assertThat(finding.found()).contains("a robot stood for 1 s");
    }

    @Test
    void functionWithDifferentResultsIsReported() {
        List<MathFingerprint> fingerprints =
                List.of(new MathFingerprint("sin", 1, 1), new MathFingerprint("pow", 1, 2));

        Finding finding = JavaCheck.mathematics(fingerprints);

        assertThat(finding.verdict()).isEqualTo(Verdict.BROKEN);
        assertThat(finding.found()).startsWith("pow:");
    }

    @Test
    void freePortIsReported() throws IOException {
        int port = freePort();

        assertThat(PortCheck.of("Agent port", port).found()).isEqualTo(port + " is free");
    }

    @Test
    void simulatorAtTheMonitorPortIsRecognised() throws IOException {
        SimulatorSettings settings = SimulatorSettings.of(
                        WorldSettings.beginner().withSynchronous(false))
                .withAgentPort(0)
                .withMonitorPort(0);
        try (Simulator simulator = Simulator.start(settings, Console.silent())) {
            Finding finding =
                    PortCheck.of("Monitor port", simulator.monitorPort().orElseThrow());

            assertThat(finding.verdict()).isEqualTo(Verdict.NOTABLE);
            assertThat(finding.found()).endsWith("is in use by a soccer simulator");
        }
    }

    @Test
    void silentProgramAtAPortIsReported() throws IOException {
        try (ServerSocket silent = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
            Finding finding = PortCheck.of("Agent port", silent.getLocalPort());

            assertThat(finding.found()).contains("waits for a client to speak first");
            assertThat(finding.advice()).contains("stop that program or use another port");
        }
    }

    @Test
    void folderThatIsMissingCannotBeWritten(@TempDir Path folder) {
        Finding finding = FolderCheck.of("This folder", folder.resolve("missing"));

        assertThat(finding.verdict()).isEqualTo(Verdict.NOTABLE);
        assertThat(finding.found()).endsWith("missing is not writable");
    }

    @Test
    void folderCheckLeavesNoFile(@TempDir Path folder) throws IOException {
        FolderCheck.of("This folder", folder);

        try (var files = Files.list(folder)) {
            assertThat(files).isEmpty();
        }
    }

    @Test
    void littleMemoryIsReported() {
        assertThat(JavaCheck.memory(0.1, 1).verdict()).isEqualTo(Verdict.NOTABLE);
        assertThat(JavaCheck.memory(4, 2).found()).isEqualTo("Java can use 4.0 GB; 2 processors");
    }

    @Test
    void missingBrowserCommandIsReported(@TempDir Path empty) {
        Finding finding = BrowserCheck.command("Linux", empty.toString());

        assertThat(finding.verdict()).isEqualTo(Verdict.NOTABLE);
        assertThat(finding.advice()).contains("Copy the studio's address");
    }

    @Test
    void windowsAndMacAlwaysOpenPages() {
        assertThat(List.of("Windows 11", "Mac OS X"))
                .allMatch(system -> BrowserCheck.command(system, "").verdict() == Verdict.WELL);
    }

    @Test
    void adviceStandsBelowTheFinding() {
        String text = Finding.broken("Studio", "its page answers 500", "Please report this.")
                .toText();

        assertThat(text.lines())
                .containsExactly(
                        "FAIL  Studio         its page answers 500", " ".repeat(21) + "-> Please report this.");
        assertThat(Finding.well("Java", "17").toText()).isEqualTo("ok    Java           17");
    }

    private static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return socket.getLocalPort();
        }
    }

    @Tag("slow")
    @Test
    void exerciseIsGradedAsStudentsDoIt() {
        Finding finding = ExerciseCheckup.graded();

        assertThat(finding.verdict()).as(finding.toText()).isEqualTo(Verdict.WELL);
        assertThat(finding.found()).contains("raise-arms was compiled, run and graded");
    }

    @Test
    void slowStartIsReported() {
        assertThat(StartTimeCheck.of(1.2).verdict()).isEqualTo(Verdict.WELL);
        assertThat(StartTimeCheck.of(9).advice()).contains("virus scanning");
        assertThat(StartTimeCheck.measured().found()).contains(" s, the best of 2");
    }

    @Test
    void graphicsWithoutABrowserAreLookedAtByHand(@TempDir Path folder) throws IOException {
        Path browser =
                Files.writeString(folder.resolve("chromium"), "#!/bin/sh\necho '<body>webgl-is-missing</body>'\n");
        assumeThat(browser.toFile().setExecutable(true)).isTrue();
        assumeThat(File.separatorChar).isEqualTo('/');

        assertThat(GraphicsCheck.drawn(folder.resolve("none").toString()).advice())
                .contains("opening the studio once");
        assertThat(GraphicsCheck.drawn(folder.toString()).found()).contains("does not support 3D graphics");
    }
}
