package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
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

        AccessToken first = AccessToken.keptIn(file, Instant.now());

        assertThat(AccessToken.keptIn(file, Instant.now())).isEqualTo(first);
        assertThat(folder.resolve("new")).isDirectoryContaining(file::equals);
        assertThat(folder.resolve("new").toFile().list()).hasSize(1);
    }

    @Test
    void keptTokenIsForItsOwnerOnly(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("token");

        AccessToken.keptIn(file, Instant.now());

        if (Files.getFileAttributeView(file, PosixFileAttributeView.class) != null) {
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                    .isEqualTo("rw-------");
        }
    }

    @Test
    void damagedTokenIsReplaced(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("token"), "no token");

        AccessToken token = AccessToken.keptIn(file, Instant.now());

        assertThat(Files.readString(file)).isEqualTo(token.text() + "\n");
    }

    @Test
    void wrongFormIsRefused() {
        assertThatThrownBy(() -> new AccessToken("abc"))
                .hasMessage("An access token has 32 hexadecimal digits, not \"abc\".");
    }

    @Test
    void keptTokenLastsADay(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("token");
        AccessToken today = AccessToken.keptIn(file, Instant.now());

        assertThat(AccessToken.keptIn(file, Instant.now().plus(Duration.ofHours(23))))
                .isEqualTo(today);
        assertThat(AccessToken.keptIn(file, Instant.now().plus(Duration.ofHours(25))))
                .isNotEqualTo(today);
    }

    @Test
    void eachPortHasItsOwnSecretWhichDoesNotShowTheToken() {
        AccessToken token = AccessToken.random();

        assertThat(token.secretOf(3400)).isEqualTo(token.secretOf(3400)).isNotEqualTo(token.secretOf(3401));
        assertThat(token.secretOf(3400))
                .isNotEqualTo(AccessToken.random().secretOf(3400))
                .doesNotContain(token.text());
    }
}
