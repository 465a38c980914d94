package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.tools.attach.VirtualMachine;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.programs.process.JavaCommand;

/** A judge decides by itself: no graded program can load code into it. */
class AttachTest {

    private static final String OPTION = "-XX:+DisableAttachMechanism";

    @Test
    void nothingCanBeAttachedToAProcessOfThisProgram() throws IOException {
        List<String> command =
                JavaCommand.ofCommand(List.of("simulator", "--agent-port", "0", "--monitor-port", "0", "--fast"));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        try (BufferedReader lines = process.inputReader()) {
            assertThat(lines.readLine()).isNotBlank();

            assertThatThrownBy(() -> VirtualMachine.attach(Long.toString(process.pid())))
                    .isInstanceOf(Exception.class)
                    .hasMessageNotContaining("No such process");
        } finally {
            process.destroyForcibly();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"robonewbie", "robonewbie.cmd", "app/src/launcher/java/Build.java"})
    void launchersStartAJavaToWhichNothingCanBeAttached(String file) throws IOException {
        Path launcher = Project.ROOT.resolve(file);

        assertThat(Files.readString(launcher)).contains(OPTION);
    }
}
