package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AccessTokenTest {

    @Test
    void tokensDiffer() {
        assertThat(AccessToken.random()).isNotEqualTo(AccessToken.random());
    }

    @Test
    void keptTokenIsTheSameInTheNextRun(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("new").resolve("token");

        AccessToken first = AccessToken.keptIn(file);

        assertThat(AccessToken.keptIn(file)).isEqualTo(first);
        assertThat(folder.resolve("new")).isDirectoryContaining(file::equals);
        assertThat(folder.resolve("new").toFile().list()).hasSize(1);
    }

    @Test
    void keptTokenIsForItsOwnerOnly(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("token");

        AccessToken.keptIn(file);

        if (Files.getFileAttributeView(file, PosixFileAttributeView.class) != null) {
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                    .isEqualTo("rw-------");
        }
    }

    @Test
    void damagedTokenIsReplaced(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("token"), "no token");

        AccessToken token = AccessToken.keptIn(file);

        assertThat(Files.readString(file)).isEqualTo(token.text() + "\n");
    }

    @Test
    void wrongFormIsRefused() {
        assertThatThrownBy(() -> new AccessToken("abc"))
                .hasMessage("An access token has 32 hexadecimal digits, not \"abc\".");
    }

    @Test
    void onlyTheSameTextMatches() {
        AccessToken token = AccessToken.random();

        assertThat(token.matches(token.text())).isTrue();
        assertThat(token.matches(token.text() + "0")).isFalse();
        assertThat(token.matches("")).isFalse();
    }
}
