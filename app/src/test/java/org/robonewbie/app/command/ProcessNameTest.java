package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

class ProcessNameTest {

    private static final Path NAME = Path.of("/proc/self/comm");

    @Test
    @EnabledOnOs(OS.LINUX)
    void systemListsTheProgramUnderItsNewName() throws IOException {
        String before = Files.readString(NAME).trim();
        try {
            ProcessName.set("rcssserver3d");

            assertThat(Files.readString(NAME).trim()).isEqualTo("rcssserver3d");
        } finally {
            ProcessName.set(before);
        }
    }
}
