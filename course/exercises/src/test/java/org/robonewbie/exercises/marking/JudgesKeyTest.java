package org.robonewbie.exercises.marking;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class JudgesKeyTest {

    @TempDir
    private Path folder;

    @EnabledOnOs(OS.LINUX)
    @Test
    void keyOfTheJudgeIsReadableForItsOwnerOnly() throws IOException {
        Path file = folder.resolve("home/judges-key");

        String signature = JudgesKey.of(file).sign("a mark");

        assertThat(Files.getPosixFilePermissions(file)).isEqualTo(PosixFilePermissions.fromString("rw-------"));
        assertThat(JudgesKey.of(file).hasSigned("a mark", signature)).isTrue();
        assertThat(JudgesKey.of(file).hasSigned("another mark", signature)).isFalse();
        assertThat(JudgesKey.of(folder.resolve("other/judges-key")).hasSigned("a mark", signature))
                .isFalse();
    }
}
